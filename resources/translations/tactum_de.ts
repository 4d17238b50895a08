<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
    <context>
        <name>Tactum</name>
        <message>
            <source>  at %1 s</source>
            <translation>  bei %1 s</translation>
        </message>
        <message>
            <source>  at %1, %2, %3 mm</source>
            <translation>  bei %1, %2, %3 mm</translation>
        </message>
        <message>
            <source> %1 came back with the feel of before.</source>
            <translation> %1: wieder mit der Haptik von zuvor.</translation>
        </message>
        <message>
            <source> %1 was %2 across and has been scaled to %3 so that it fits a hand.</source>
            <translation> %1 war %2 groß und wurde auf %3 skaliert, passend zur Hand.</translation>
        </message>
        <message>
            <source> Hangs on nothing now: %1.</source>
            <translation> Hängt jetzt an nichts: %1.</translation>
        </message>
        <message>
            <source> Left out: %1.</source>
            <translation> Ausgelassen: %1.</translation>
        </message>
        <message>
            <source> Lowered %1 times.</source>
            <translation> %1-mal verringert.</translation>
        </message>
        <message>
            <source> Lowered once.</source>
            <translation> Einmal verringert.</translation>
        </message>
        <message>
            <source> N</source>
            <translation> N</translation>
        </message>
        <message>
            <source> One unit is taken as 1 %1 and no longer as 1 %2, by which it would be %3 than before.</source>
            <translation> Eine Einheit wird als 1 %1 gelesen und nicht mehr als 1 %2, womit es %3 wäre als zuvor.</translation>
        </message>
        <message>
            <source> They are %1 than before.</source>
            <translation> Sie sind %1 als zuvor.</translation>
        </message>
        <message>
            <source> Undo brings all of it back.</source>
            <translation> Rückgängig bringt alles zurück.</translation>
        </message>
        <message>
            <source> and memory that may be swapped out</source>
            <translation> und mit Speicher, der ausgelagert werden kann</translation>
        </message>
        <message>
            <source> by RealtimeKit</source>
            <translation> von RealtimeKit</translation>
        </message>
        <message>
            <source> by the desktop portal</source>
            <translation> vom Desktop-Portal</translation>
        </message>
        <message>
            <source> servo ticks</source>
            <translation> Servotakte</translation>
        </message>
        <message>
            <source>%1 %</source>
            <translation>%1 %</translation>
        </message>
        <message>
            <source>%1 % warm</source>
            <translation>%1 % warm</translation>
        </message>
        <message>
            <source>%1 %2</source>
            <translation>%1 %2</translation>
        </message>
        <message>
            <source>%1 (%2)</source>
            <translation>%1 (%2)</translation>
        </message>
        <message>
            <source>%1 (off)</source>
            <translation>%1 (aus)</translation>
        </message>
        <message>
            <source>%1 (on)</source>
            <translation>%1 (an)</translation>
        </message>
        <message>
            <source>%1 - Tactum</source>
            <translation>%1 - Tactum</translation>
        </message>
        <message>
            <source>%1 - about %2 left</source>
            <translation>%1 - noch etwa %2</translation>
        </message>
        <message>
            <source>%1 / %2 s</source>
            <translation>%1 / %2 s</translation>
        </message>
        <message>
            <source>%1 N s/m</source>
            <translation>%1 N s/m</translation>
        </message>
        <message>
            <source>%1 N/m</source>
            <translation>%1 N/m</translation>
        </message>
        <message>
            <source>%1 They hold from the next connection on, which comes when you close this.</source>
            <translation>%1 Sie gelten ab der nächsten Verbindung, die kommt, wenn Sie dies schließen.</translation>
        </message>
        <message>
            <source>%1 What was left out comes back by itself when there is time for it. Hide objects, or close what else keeps the machine busy.</source>
            <translation>%1 Was ausgelassen wurde, kommt von selbst zurück, wenn Zeit dafür ist. Objekte ausblenden oder schließen, was den Rechner sonst beschäftigt.</translation>
        </message>
        <message>
            <source>%1 across</source>
            <translation>%1 groß</translation>
        </message>
        <message>
            <source>%1 across, scaled to %2</source>
            <translation>%1 groß, auf %2 skaliert</translation>
        </message>
        <message>
            <source>%1 and %2 are exchanged.</source>
            <translation>%1 und %2 sind vertauscht.</translation>
        </message>
        <message>
            <source>%1 asks to edit.</source>
            <translation>%1 möchte bearbeiten.</translation>
        </message>
        <message>
            <source>%1 at %2</source>
            <translation>%1 bei %2</translation>
        </message>
        <message>
            <source>%1 cannot be brought back.</source>
            <translation>%1 kann nicht zurückgeholt werden.</translation>
        </message>
        <message>
            <source>%1 cannot be removed. Check the rights of its folder.</source>
            <translation>%1 kann nicht entfernt werden. Rechte des Ordners prüfen.</translation>
        </message>
        <message>
            <source>%1 cannot be written. Choose another folder, or make room on the disk.</source>
            <translation>%1 kann nicht geschrieben werden. Anderen Ordner wählen oder Platz auf dem Datenträger schaffen.</translation>
        </message>
        <message>
            <source>%1 could not be made ready</source>
            <translation>%1 konnte nicht bereit gemacht werden</translation>
        </message>
        <message>
            <source>%1 does not play 16 bits at 48 kHz</source>
            <translation>%1 spielt keine 16 Bit bei 48 kHz ab</translation>
        </message>
        <message>
            <source>%1 does not say its unit: %2</source>
            <translation>%1 nennt keine Einheit: %2</translation>
        </message>
        <message>
            <source>%1 does not say its up axis: %2</source>
            <translation>%1 nennt keine Hochachse: %2</translation>
        </message>
        <message>
            <source>%1 edits</source>
            <translation>%1 bearbeitet</translation>
        </message>
        <message>
            <source>%1 files</source>
            <translation>%1 Dateien</translation>
        </message>
        <message>
            <source>%1 files are in the scene now.</source>
            <translation>%1 Dateien sind jetzt in der Szene.</translation>
        </message>
        <message>
            <source>%1 gives no readings any more: look at its cable and its supply. It is made ready again by itself when it is there.</source>
            <translation>%1 liefert keine Messwerte mehr: Kabel und Stromversorgung prüfen. Es wird von selbst wieder bereit gemacht, wenn es da ist.</translation>
        </message>
        <message>
            <source>%1 goes from %2 to %3.</source>
            <translation>%1 reicht von %2 bis %3.</translation>
        </message>
        <message>
            <source>%1 has %2 layers, and more are not felt. Remove one first.</source>
            <translation>%1 hat %2 Ebenen, und mehr werden nicht gefühlt. Zuerst eine entfernen.</translation>
        </message>
        <message>
            <source>%1 has a locked surface. Unlock it first.</source>
            <translation>%1 hat eine gesperrte Oberfläche. Diese zuerst entsperren.</translation>
        </message>
        <message>
            <source>%1 has another scene, which is shown now.</source>
            <translation>%1 hat eine andere Szene, die jetzt gezeigt wird.</translation>
        </message>
        <message>
            <source>%1 has been changed or removed since it was opened.</source>
            <translation>%1 wurde seit dem Öffnen geändert oder entfernt.</translation>
        </message>
        <message>
            <source>%1 has changed the scene; Undo brings the one before back.</source>
            <translation>%1 hat die Szene geändert; Rückgängig bringt die vorige zurück.</translation>
        </message>
        <message>
            <source>%1 has no feel from here</source>
            <translation>%1 ohne Haptik von hier</translation>
        </message>
        <message>
            <source>%1 has none of what you paint: the brush scales it. Set it above 0 to feel it.</source>
            <translation>%1 hat nichts von dem, was Sie malen: Der Pinsel skaliert es. Auf einen Wert über 0 setzen, um es zu fühlen.</translation>
        </message>
        <message>
            <source>%1 has parts on %2 objects, and triangles are selected on one: on %3. Select another of them first for its part.</source>
            <translation>%1 hat Teile auf %2 Objekten, und Dreiecke sind auf einem ausgewählt: auf %3. Für den Teil eines anderen erst dieses auswählen.</translation>
        </message>
        <message>
            <source>%1 has the shapes that are here already.</source>
            <translation>%1 hat die Formen, die schon hier sind.</translation>
        </message>
        <message>
            <source>%1 have no feel from here</source>
            <translation>%1 ohne Haptik von hier</translation>
        </message>
        <message>
            <source>%1 is a mere number.</source>
            <translation>%1 ist eine bloße Zahl.</translation>
        </message>
        <message>
            <source>%1 is as it was before the program stopped, but without its history, which cannot be read.</source>
            <translation>%1 ist, wie es vor dem Programmabbruch war, aber ohne den Verlauf, der nicht gelesen werden kann.</translation>
        </message>
        <message>
            <source>%1 is as it was before the program stopped, with its history.</source>
            <translation>%1 ist, wie es vor dem Programmabbruch war, mit dem Verlauf.</translation>
        </message>
        <message>
            <source>%1 is at the haptic server %2. Which device that is is said where the server is started: tactum serve --device. One of this computer is connected in a window without a server.</source>
            <translation>%1 ist am haptischen Server %2. Welches Gerät das ist, wird dort gesagt, wo der Server gestartet wird: tactum serve --device. Eines an diesem Rechner wird in einem Fenster ohne Server verbunden.</translation>
        </message>
        <message>
            <source>%1 is empty now: throw the changes away before %2?</source>
            <translation>%1 ist jetzt leer: Änderungen vor %2 verwerfen?</translation>
        </message>
        <message>
            <source>%1 is gone: nothing vibrates until a gamepad is connected.</source>
            <translation>%1 ist nicht mehr da: Nichts vibriert, bis ein Gamepad angeschlossen ist.</translation>
        </message>
        <message>
            <source>%1 is in the library now.</source>
            <translation>%1 ist jetzt in der Bibliothek.</translation>
        </message>
        <message>
            <source>%1 is in the scene now.</source>
            <translation>%1 ist jetzt in der Szene.</translation>
        </message>
        <message>
            <source>%1 is locked; Surface &gt; Lock unlocks it.</source>
            <translation>%1 ist gesperrt; Oberfläche &gt; Sperren entsperrt es.</translation>
        </message>
        <message>
            <source>%1 is locked; unlock it first (L).</source>
            <translation>%1 ist gesperrt; zuerst entsperren (L).</translation>
        </message>
        <message>
            <source>%1 is loose</source>
            <translation>%1 ist lose</translation>
        </message>
        <message>
            <source>%1 is measured in %2.</source>
            <translation>%1 wird in %2 gemessen.</translation>
        </message>
        <message>
            <source>%1 is not there any more and gets no force; the other hand goes on. Its own goes when you switch the forces off. Plug it in: it is made ready again by itself.</source>
            <translation>%1 ist nicht mehr da und bekommt keine Kraft; die andere Hand macht weiter. Seine eigene verschwindet, wenn Sie die Kräfte ausschalten. Wieder anschließen: Es wird von selbst bereit gemacht.</translation>
        </message>
        <message>
            <source>%1 is not there any more and gets no force; the other hand goes on. When you switch the forces off, the mouse leads a simulated hand in its place.</source>
            <translation>%1 ist nicht mehr da und bekommt keine Kraft; die andere Hand macht weiter. Wenn Sie die Kräfte ausschalten, führt die Maus an seiner Stelle eine simulierte Hand.</translation>
        </message>
        <message>
            <source>%1 is not there any more, and its hand went with it. Plug it in: it is made ready again by itself.</source>
            <translation>%1 ist nicht mehr da und seine Hand mit ihm. Wieder anschließen: Es wird von selbst bereit gemacht.</translation>
        </message>
        <message>
            <source>%1 is not there any more; the forces are off. Plug it in: it is made ready again by itself. Until then the mouse leads a simulated hand.</source>
            <translation>%1 ist nicht mehr da; die Kräfte sind aus. Wieder anschließen: Es wird von selbst bereit gemacht. Bis dahin führt die Maus eine simulierte Hand.</translation>
        </message>
        <message>
            <source>%1 is ready. The forces are off: hold the handle, then arm.</source>
            <translation>%1 ist bereit. Die Kräfte sind aus: Griff halten, dann Kräfte einschalten.</translation>
        </message>
        <message>
            <source>%1 is there already. Replace it?</source>
            <translation>%1 gibt es schon. Ersetzen?</translation>
        </message>
        <message>
            <source>%1 is there and ready. The forces are off: hold the handle, then arm.</source>
            <translation>%1 ist da und bereit. Die Kräfte sind aus: Griff halten, dann Kräfte einschalten.</translation>
        </message>
        <message>
            <source>%1 joints went with it.</source>
            <translation>%1 Gelenke wurden mit entfernt.</translation>
        </message>
        <message>
            <source>%1 mJ</source>
            <translation>%1 mJ</translation>
        </message>
        <message>
            <source>%1 moves by its keys; it cannot be pushed.</source>
            <translation>%1 bewegt sich nach Keyframes; es kann nicht geschoben werden.</translation>
        </message>
        <message>
            <source>%1 moves from now on, as time runs.</source>
            <translation>%1 bewegt sich ab jetzt, denn die Zeit läuft.</translation>
        </message>
        <message>
            <source>%1 ms</source>
            <translation>%1 ms</translation>
        </message>
        <message>
            <source>%1 multiplied</source>
            <translation>%1 multipliziert</translation>
        </message>
        <message>
            <source>%1 objects</source>
            <translation>%1 Objekte</translation>
        </message>
        <message>
            <source>%1 objects, the figures of %2</source>
            <translation>%1 Objekte, die Werte von %2</translation>
        </message>
        <message>
            <source>%1 of %2</source>
            <translation>%1 von %2</translation>
        </message>
        <message>
            <source>%1 of %2 Hz</source>
            <translation>%1 von %2 Hz</translation>
        </message>
        <message>
            <source>%1 of %2 are locked and stay as they are.</source>
            <translation>%1 von %2 sind gesperrt und bleiben, wie sie sind.</translation>
        </message>
        <message>
            <source>%1 of %2 are not there any more</source>
            <translation>%1 von %2 nicht mehr da</translation>
        </message>
        <message>
            <source>%1 of %2 is not there any more</source>
            <translation>%1 von %2 nicht mehr da</translation>
        </message>
        <message>
            <source>%1 of layer %2</source>
            <translation>%1 der Ebene %2</translation>
        </message>
        <message>
            <source>%1 of our own, %2 of the machine's</source>
            <translation>%1 eigene, %2 der Maschine</translation>
        </message>
        <message>
            <source>%1 of the mask</source>
            <translation>%1 der Maske</translation>
        </message>
        <message>
            <source>%1 of the world</source>
            <translation>%1 der Welt</translation>
        </message>
        <message>
            <source>%1 on a hinge</source>
            <translation>%1 an einem Scharnier</translation>
        </message>
        <message>
            <source>%1 on a path</source>
            <translation>%1 auf einer Bahn</translation>
        </message>
        <message>
            <source>%1 on a slider</source>
            <translation>%1 auf einer Schiene</translation>
        </message>
        <message>
            <source>%1 over time</source>
            <translation>%1 über der Zeit</translation>
        </message>
        <message>
            <source>%1 readings a second</source>
            <translation>%1 Messwerte je Sekunde</translation>
        </message>
        <message>
            <source>%1 reads %2 times as far as the ruler says.</source>
            <translation>%1 zeigt das %2-Fache dessen, was das Lineal sagt.</translation>
        </message>
        <message>
            <source>%1 runs the other way: its reading falls when the handle moves %2. The driver has to be repaired.</source>
            <translation>%1 läuft andersherum: Der Messwert fällt, wenn der Griff sich %2 bewegt. Der Treiber muss berichtigt werden.</translation>
        </message>
        <message>
            <source>%1 s</source>
            <translation>%1 s</translation>
        </message>
        <message>
            <source>%1 s: %2</source>
            <translation>%1 s: %2</translation>
        </message>
        <message>
            <source>%1 says neither unit nor up axis: %2</source>
            <translation>%1 nennt weder Einheit noch Hochachse: %2</translation>
        </message>
        <message>
            <source>%1 so far</source>
            <translation>bisher %1</translation>
        </message>
        <message>
            <source>%1 stands still</source>
            <translation>%1 steht still</translation>
        </message>
        <message>
            <source>%1 surfaces</source>
            <translation>%1 Oberflächen</translation>
        </message>
        <message>
            <source>%1 times as large</source>
            <translation>%1-mal so groß</translation>
        </message>
        <message>
            <source>%1 times larger</source>
            <translation>%1-mal größer</translation>
        </message>
        <message>
            <source>%1 times smaller</source>
            <translation>%1-mal kleiner</translation>
        </message>
        <message>
            <source>%1 to %2 µs</source>
            <translation>%1 bis %2 µs</translation>
        </message>
        <message>
            <source>%1 to %2, default %3</source>
            <translation>%1 bis %2, Standard %3</translation>
        </message>
        <message>
            <source>%1 triangles</source>
            <translation>%1 Dreiecke</translation>
        </message>
        <message>
            <source>%1 vibrates with what is felt.</source>
            <translation>%1 vibriert mit dem, was gefühlt wird.</translation>
        </message>
        <message>
            <source>%1 was changed by another program. Its new shapes can take the feel of this scene.</source>
            <translation>%1 wurde von einem anderen Programm geändert. Die neuen Formen können die Haptik dieser Szene übernehmen.</translation>
        </message>
        <message>
            <source>%1 was left out</source>
            <translation>%1 ausgelassen</translation>
        </message>
        <message>
            <source>%1 was left out: the object was changed meanwhile. Do it again.</source>
            <translation>%1 wurde ausgelassen: Das Objekt wurde inzwischen geändert. Noch einmal ausführen.</translation>
        </message>
        <message>
            <source>%1 was left out: the scene was edited meanwhile. Add it again.</source>
            <translation>%1 wurde ausgelassen: Die Szene wurde inzwischen bearbeitet. Noch einmal hinzufügen.</translation>
        </message>
        <message>
            <source>%1 was left out: the scene was edited meanwhile. Update it again.</source>
            <translation>%1 wurde ausgelassen: Die Szene wurde inzwischen bearbeitet. Noch einmal aktualisieren.</translation>
        </message>
        <message>
            <source>%1 was not opened anew: the scene was edited meanwhile.</source>
            <translation>%1 wurde nicht neu geöffnet: Die Szene wurde inzwischen bearbeitet.</translation>
        </message>
        <message>
            <source>%1 was not saved: edited until %2 on %3.</source>
            <translation>%1 wurde nicht gespeichert: bearbeitet bis %2 am %3.</translation>
        </message>
        <message>
            <source>%1 was not saved: edited until %2.</source>
            <translation>%1 wurde nicht gespeichert: bearbeitet bis %2.</translation>
        </message>
        <message>
            <source>%1 was thrown away.</source>
            <translation>%1 wurde verworfen.</translation>
        </message>
        <message>
            <source>%1 were left out</source>
            <translation>%1 ausgelassen</translation>
        </message>
        <message>
            <source>%1 x %2, %3 bits</source>
            <translation>%1 x %2, %3 Bit</translation>
        </message>
        <message>
            <source>%1 µs</source>
            <translation>%1 µs</translation>
        </message>
        <message>
            <source>%1 · forces off</source>
            <translation>%1 · Kräfte aus</translation>
        </message>
        <message>
            <source>%1 · in use
%2</source>
            <translation>%1 · in Gebrauch
%2</translation>
        </message>
        <message>
            <source>%1 · limit</source>
            <translation>%1 · Limit</translation>
        </message>
        <message>
            <source>%1 · not usable
%2</source>
            <translation>%1 · nicht verwendbar
%2</translation>
        </message>
        <message>
            <source>%1 × %2 × %3</source>
            <translation>%1 × %2 × %3</translation>
        </message>
        <message>
            <source>%1, %2, %3 mm</source>
            <translation>%1, %2, %3 mm</translation>
        </message>
        <message>
            <source>%1, at the edge</source>
            <translation>%1, am Rand</translation>
        </message>
        <message>
            <source>%1, or what goes along with it, is locked; Surface &gt; Lock unlocks it.</source>
            <translation>%1 oder was damit verbunden ist, ist gesperrt; Oberfläche &gt; Sperren entsperrt es.</translation>
        </message>
        <message>
            <source>%1, parallel</source>
            <translation>%1, parallel</translation>
        </message>
        <message>
            <source>%1, slider</source>
            <translation>%1, Regler</translation>
        </message>
        <message>
            <source>%1, step "%2"</source>
            <translation>%1, Schritt "%2"</translation>
        </message>
        <message>
            <source>%1, turned</source>
            <translation>%1, gedreht</translation>
        </message>
        <message>
            <source>%1. Stiffness up to %2 N/m, %3.</source>
            <translation>%1. Steifigkeit bis %2 N/m, %3.</translation>
        </message>
        <message>
            <source>%1: %2</source>
            <translation>%1: %2</translation>
        </message>
        <message>
            <source>%1: %2 %3</source>
            <translation>%1: %2 %3</translation>
        </message>
        <message>
            <source>%1: %2 (T selects it)</source>
            <translation>%1: %2 (T wählt es aus)</translation>
        </message>
        <message>
            <source>%1: %2 N/m, friction %3 / %4</source>
            <translation>%1: %2 N/m, Reibung %3 / %4</translation>
        </message>
        <message>
            <source>%1: %2. Undo takes it back.</source>
            <translation>%1: %2. Rückgängig nimmt es zurück.</translation>
        </message>
        <message>
            <source>%1: %2; repair this one in the modelling program.</source>
            <translation>%1: %2; dies im Modellierprogramm reparieren.</translation>
        </message>
        <message numerus="yes">
            <source>%1: %n tick(s), %2</source>
            <translation>
                <numerusform>%1: %n Takt, %2</numerusform>
                <numerusform>%1: %n Takte, %2</numerusform>
            </translation>
        </message>
        <message>
            <source>%1: cannot be taken over: %2; check the permissions of the folder.</source>
            <translation>%1: kann nicht übernommen werden: %2; Rechte des Ordners prüfen.</translation>
        </message>
        <message>
            <source>%1: given up</source>
            <translation>%1: aufgegeben</translation>
        </message>
        <message>
            <source>%1: not felt</source>
            <translation>%1: nicht gefühlt</translation>
        </message>
        <message>
            <source>%1: nothing can be heard.</source>
            <translation>%1: Es ist nichts zu hören.</translation>
        </message>
        <message>
            <source>%1: sticking</source>
            <translation>%1: haftet</translation>
        </message>
        <message>
            <source>%1[*] - Tactum</source>
            <translation>%1[*] - Tactum</translation>
        </message>
        <message numerus="yes">
            <source>%n picture(s) were left out, for the encoder could not follow; a smaller size takes less.</source>
            <translation>
                <numerusform>Ausgelassene Bilder: %n, denn der Encoder kam nicht mit; eine kleinere Größe braucht weniger.</numerusform>
                <numerusform>Ausgelassene Bilder: %n, denn der Encoder kam nicht mit; eine kleinere Größe braucht weniger.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n question(s) after each</source>
            <translation>
                <numerusform>%n Frage nach jedem</numerusform>
                <numerusform>%n Fragen nach jedem</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n trial(s)</source>
            <translation>
                <numerusform>%n Durchgang</numerusform>
                <numerusform>%n Durchgänge</numerusform>
            </translation>
        </message>
        <message>
            <source>&amp;About Tactum</source>
            <translation>Über T&amp;actum</translation>
        </message>
        <message>
            <source>&amp;Add</source>
            <translation>&amp;Hinzufügen</translation>
        </message>
        <message>
            <source>&amp;Add a device</source>
            <translation>&amp;Gerät hinzufügen</translation>
        </message>
        <message>
            <source>&amp;Agree on fronts</source>
            <translation>&amp;Vorderseiten angleichen</translation>
        </message>
        <message>
            <source>&amp;All surfaces</source>
            <translation>&amp;Alle Oberflächen</translation>
        </message>
        <message>
            <source>&amp;At the contact</source>
            <translation>A&amp;m Kontakt</translation>
        </message>
        <message>
            <source>&amp;Back to the scene</source>
            <translation>&amp;Zurück zur Szene</translation>
        </message>
        <message>
            <source>&amp;Back to the start</source>
            <translation>Zurück zum &amp;Anfang</translation>
        </message>
        <message>
            <source>&amp;Box</source>
            <translation>&amp;Box</translation>
        </message>
        <message>
            <source>&amp;Browse...</source>
            <translation>&amp;Durchsuchen...</translation>
        </message>
        <message>
            <source>&amp;Bumps</source>
            <translation>Erheb&amp;ungen</translation>
        </message>
        <message>
            <source>&amp;Camera</source>
            <translation>&amp;Kamera</translation>
        </message>
        <message>
            <source>&amp;Compare now</source>
            <translation>&amp;Jetzt vergleichen</translation>
        </message>
        <message>
            <source>&amp;Connect</source>
            <translation>&amp;Verbinden</translation>
        </message>
        <message>
            <source>&amp;Connect to a server...</source>
            <translation>Mit einem Server &amp;verbinden...</translation>
        </message>
        <message>
            <source>&amp;Continue</source>
            <translation>&amp;Weiter</translation>
        </message>
        <message>
            <source>&amp;Copy feel</source>
            <translation>Haptik &amp;kopieren</translation>
        </message>
        <message>
            <source>&amp;Copy the measure</source>
            <translation>Maß k&amp;opieren</translation>
        </message>
        <message>
            <source>&amp;Cut the model open</source>
            <translation>Modell auf&amp;schneiden</translation>
        </message>
        <message>
            <source>&amp;Cylinder</source>
            <translation>&amp;Zylinder</translation>
        </message>
        <message>
            <source>&amp;Damping</source>
            <translation>&amp;Dämpfung</translation>
        </message>
        <message>
            <source>&amp;Dark</source>
            <translation>&amp;Dunkel</translation>
        </message>
        <message>
            <source>&amp;Defaults of this page</source>
            <translation>&amp;Standardwerte dieser Seite</translation>
        </message>
        <message>
            <source>&amp;Devices</source>
            <translation>&amp;Geräte</translation>
        </message>
        <message>
            <source>&amp;Distribute along x</source>
            <translation>&amp;Gleichmäßig entlang x verteilen</translation>
        </message>
        <message>
            <source>&amp;Down in the list</source>
            <translation>In der Liste nach &amp;unten</translation>
        </message>
        <message>
            <source>&amp;Duplicate</source>
            <translation>&amp;Duplizieren</translation>
        </message>
        <message>
            <source>&amp;Dynamic friction</source>
            <translation>&amp;Gleitreibung</translation>
        </message>
        <message>
            <source>&amp;Each about its own</source>
            <translation>&amp;Jedes um seine Mitte</translation>
        </message>
        <message>
            <source>&amp;Export a bundle...</source>
            <translation>Bündel &amp;exportieren...</translation>
        </message>
        <message>
            <source>&amp;Export the preset...</source>
            <translation>Vorgabe e&amp;xportieren...</translation>
        </message>
        <message>
            <source>&amp;Farther</source>
            <translation>&amp;Weiter weg</translation>
        </message>
        <message>
            <source>&amp;Find a command...</source>
            <translation>Be&amp;fehl suchen...</translation>
        </message>
        <message>
            <source>&amp;Folder of certificate and token</source>
            <translation>&amp;Ordner von Zertifikat und Token</translation>
        </message>
        <message>
            <source>&amp;Forces on</source>
            <translation>&amp;Kräfte an</translation>
        </message>
        <message>
            <source>&amp;Four</source>
            <translation>&amp;Vier</translation>
        </message>
        <message>
            <source>&amp;Frame all</source>
            <translation>&amp;Alles zeigen</translation>
        </message>
        <message>
            <source>&amp;Gamepad</source>
            <translation>Game&amp;pad</translation>
        </message>
        <message>
            <source>&amp;Go on after trial %1, where the last run broke off</source>
            <translation>Nach Durchgang %1 &amp;fortsetzen, wo der letzte Lauf abbrach</translation>
        </message>
        <message>
            <source>&amp;Go on: no run of this participant broke off</source>
            <translation>&amp;Fortsetzen: kein Lauf dieser Person brach ab</translation>
        </message>
        <message>
            <source>&amp;Ground and shadow</source>
            <translation>&amp;Boden und Schatten</translation>
        </message>
        <message>
            <source>&amp;Group</source>
            <translation>Grupp&amp;ieren</translation>
        </message>
        <message>
            <source>&amp;Grow</source>
            <translation>&amp;Erweitern</translation>
        </message>
        <message>
            <source>&amp;Guide</source>
            <translation>&amp;Handbuch</translation>
        </message>
        <message>
            <source>&amp;Hands</source>
            <translation>Hä&amp;nde</translation>
        </message>
        <message>
            <source>&amp;Hear the contact</source>
            <translation>Kontakt &amp;hören</translation>
        </message>
        <message>
            <source>&amp;Height</source>
            <translation>&amp;Höhe</translation>
        </message>
        <message>
            <source>&amp;Height of texture</source>
            <translation>Höhe der &amp;Textur</translation>
        </message>
        <message>
            <source>&amp;Hide</source>
            <translation>&amp;Ausblenden</translation>
        </message>
        <message>
            <source>&amp;Import presets...</source>
            <translation>Vorgaben i&amp;mportieren...</translation>
        </message>
        <message>
            <source>&amp;Keep this state as...</source>
            <translation>Zustand fest&amp;halten als...</translation>
        </message>
        <message>
            <source>&amp;Keep this view...</source>
            <translation>Diese &amp;Ansicht behalten...</translation>
        </message>
        <message>
            <source>&amp;Kept cameras</source>
            <translation>&amp;Gespeicherte Kameras</translation>
        </message>
        <message>
            <source>&amp;Keyboard</source>
            <translation>&amp;Tastatur</translation>
        </message>
        <message>
            <source>&amp;Larger brush</source>
            <translation>&amp;Größerer Pinsel</translation>
        </message>
        <message>
            <source>&amp;Lasso</source>
            <translation>La&amp;sso</translation>
        </message>
        <message>
            <source>&amp;Light</source>
            <translation>&amp;Hell</translation>
        </message>
        <message>
            <source>&amp;Lines between surfaces</source>
            <translation>&amp;Linien zwischen Oberflächen</translation>
        </message>
        <message>
            <source>&amp;Lock</source>
            <translation>&amp;Sperren</translation>
        </message>
        <message>
            <source>&amp;Loose body</source>
            <translation>Loser &amp;Körper</translation>
        </message>
        <message>
            <source>&amp;Make a video</source>
            <translation>Vi&amp;deo erstellen</translation>
        </message>
        <message>
            <source>&amp;Mark as A</source>
            <translation>Als A &amp;markieren</translation>
        </message>
        <message>
            <source>&amp;Mass</source>
            <translation>&amp;Masse</translation>
        </message>
        <message>
            <source>&amp;Merge</source>
            <translation>&amp;Vereinigen</translation>
        </message>
        <message>
            <source>&amp;Models...</source>
            <translation>&amp;Modelle...</translation>
        </message>
        <message>
            <source>&amp;Move</source>
            <translation>&amp;Verschieben</translation>
        </message>
        <message>
            <source>&amp;Move the mapping</source>
            <translation>Abbildung &amp;verschieben</translation>
        </message>
        <message>
            <source>&amp;Nearer</source>
            <translation>&amp;Näher</translation>
        </message>
        <message>
            <source>&amp;New study</source>
            <translation>&amp;Neue Studie</translation>
        </message>
        <message>
            <source>&amp;Next hand</source>
            <translation>&amp;Nächste Hand</translation>
        </message>
        <message>
            <source>&amp;Next panel</source>
            <translation>Nä&amp;chster Bereich</translation>
        </message>
        <message>
            <source>&amp;Normals</source>
            <translation>&amp;Normalen</translation>
        </message>
        <message>
            <source>&amp;Nothing</source>
            <translation>N&amp;ichts</translation>
        </message>
        <message>
            <source>&amp;One view</source>
            <translation>&amp;Eine Ansicht</translation>
        </message>
        <message>
            <source>&amp;Open a study...</source>
            <translation>Studie ö&amp;ffnen...</translation>
        </message>
        <message>
            <source>&amp;Open...</source>
            <translation>Ö&amp;ffnen...</translation>
        </message>
        <message>
            <source>&amp;Paint</source>
            <translation>&amp;Malen</translation>
        </message>
        <message>
            <source>&amp;Panels</source>
            <translation>B&amp;ereiche</translation>
        </message>
        <message>
            <source>&amp;Parallel projection</source>
            <translation>&amp;Parallelprojektion</translation>
        </message>
        <message>
            <source>&amp;Participant number</source>
            <translation>&amp;Nummer der Person</translation>
        </message>
        <message>
            <source>&amp;Planes</source>
            <translation>&amp;Zwangsebenen</translation>
        </message>
        <message>
            <source>&amp;Plate with friction</source>
            <translation>&amp;Platte mit Reibung</translation>
        </message>
        <message>
            <source>&amp;Procedure and questions...</source>
            <translation>&amp;Ablauf und Fragen...</translation>
        </message>
        <message>
            <source>&amp;Put the proxy on the finger</source>
            <translation>Proxy auf den &amp;Finger setzen</translation>
        </message>
        <message>
            <source>&amp;Quit</source>
            <translation>&amp;Beenden</translation>
        </message>
        <message>
            <source>&amp;Record</source>
            <translation>&amp;Aufnehmen</translation>
        </message>
        <message>
            <source>&amp;Record a stroke</source>
            <translation>&amp;Strich aufnehmen</translation>
        </message>
        <message>
            <source>&amp;Redo</source>
            <translation>Wi&amp;ederholen</translation>
        </message>
        <message>
            <source>&amp;Redo %1</source>
            <translation>Wi&amp;ederholen: %1</translation>
        </message>
        <message>
            <source>&amp;Remove layer</source>
            <translation>Ebene &amp;entfernen</translation>
        </message>
        <message>
            <source>&amp;Remove the hand</source>
            <translation>Hand &amp;entfernen</translation>
        </message>
        <message>
            <source>&amp;Rename</source>
            <translation>&amp;Umbenennen</translation>
        </message>
        <message>
            <source>&amp;Run</source>
            <translation>&amp;Laufen lassen</translation>
        </message>
        <message>
            <source>&amp;Run the study</source>
            <translation>Studie &amp;durchführen</translation>
        </message>
        <message>
            <source>&amp;Run with a participant...</source>
            <translation>Mit einer Person &amp;durchführen...</translation>
        </message>
        <message>
            <source>&amp;Same feel</source>
            <translation>&amp;Gleiche Haptik</translation>
        </message>
        <message>
            <source>&amp;Save</source>
            <translation>&amp;Speichern</translation>
        </message>
        <message>
            <source>&amp;Save the study as...</source>
            <translation>Studie &amp;speichern unter...</translation>
        </message>
        <message>
            <source>&amp;Section plane</source>
            <translation>S&amp;chnittebene</translation>
        </message>
        <message>
            <source>&amp;Select</source>
            <translation>&amp;Auswählen</translation>
        </message>
        <message>
            <source>&amp;Server</source>
            <translation>&amp;Server</translation>
        </message>
        <message>
            <source>&amp;Show</source>
            <translation>&amp;Zeigen</translation>
        </message>
        <message>
            <source>&amp;Show all</source>
            <translation>Alle &amp;einblenden</translation>
        </message>
        <message>
            <source>&amp;Skip this</source>
            <translation>Dies &amp;auslassen</translation>
        </message>
        <message>
            <source>&amp;Slow motion</source>
            <translation>&amp;Zeitlupe</translation>
        </message>
        <message>
            <source>&amp;Smooth by the crease angle</source>
            <translation>&amp;Glatt nach dem Knickwinkel</translation>
        </message>
        <message>
            <source>&amp;Solo</source>
            <translation>&amp;Solo</translation>
        </message>
        <message>
            <source>&amp;Sphere</source>
            <translation>&amp;Kugel</translation>
        </message>
        <message>
            <source>&amp;Sphere tree</source>
            <translation>Ku&amp;gelbaum</translation>
        </message>
        <message>
            <source>&amp;Split</source>
            <translation>G&amp;eteilte Ansicht</translation>
        </message>
        <message>
            <source>&amp;Spring to the centre</source>
            <translation>&amp;Feder zur Mitte</translation>
        </message>
        <message>
            <source>&amp;Start</source>
            <translation>&amp;Beginnen</translation>
        </message>
        <message>
            <source>&amp;Static friction</source>
            <translation>H&amp;aftreibung</translation>
        </message>
        <message>
            <source>&amp;Stiffness</source>
            <translation>&amp;Steifigkeit</translation>
        </message>
        <message>
            <source>&amp;Stop</source>
            <translation>&amp;Stopp</translation>
        </message>
        <message>
            <source>&amp;Subtract</source>
            <translation>&amp;Abziehen</translation>
        </message>
        <message>
            <source>&amp;Swap A and B</source>
            <translation>A und B &amp;tauschen</translation>
        </message>
        <message>
            <source>&amp;Take the last 10 s</source>
            <translation>&amp;Letzte 10 s nehmen</translation>
        </message>
        <message>
            <source>&amp;Taken as</source>
            <translation>&amp;Lesen als</translation>
        </message>
        <message>
            <source>&amp;Ten times as high</source>
            <translation>&amp;Zehnmal so hoch</translation>
        </message>
        <message>
            <source>&amp;Top</source>
            <translation>Von &amp;oben</translation>
        </message>
        <message>
            <source>&amp;Touch</source>
            <translation>&amp;Berühren</translation>
        </message>
        <message>
            <source>&amp;Trail of the proxy</source>
            <translation>&amp;Spur des Proxys</translation>
        </message>
        <message>
            <source>&amp;Two side by side</source>
            <translation>&amp;Zwei nebeneinander</translation>
        </message>
        <message>
            <source>&amp;Undo</source>
            <translation>&amp;Rückgängig</translation>
        </message>
        <message>
            <source>&amp;Undo %1</source>
            <translation>&amp;Rückgängig: %1</translation>
        </message>
        <message>
            <source>&amp;Up in the list</source>
            <translation>In der Liste nach &amp;oben</translation>
        </message>
        <message>
            <source>&amp;Update geometry from file...</source>
            <translation>Geometrie aus Datei &amp;aktualisieren...</translation>
        </message>
        <message>
            <source>&amp;Use this profile</source>
            <translation>Dieses &amp;Profil benutzen</translation>
        </message>
        <message>
            <source>&amp;Vibrate with what is felt</source>
            <translation>Mit dem Gefühlten &amp;vibrieren</translation>
        </message>
        <message>
            <source>&amp;Viscosity</source>
            <translation>&amp;Viskosität</translation>
        </message>
        <message>
            <source>&amp;Wall</source>
            <translation>&amp;Wand</translation>
        </message>
        <message>
            <source>&amp;Weaker brush</source>
            <translation>Sch&amp;wächerer Pinsel</translation>
        </message>
        <message>
            <source>&amp;Weld vertices</source>
            <translation>&amp;Ecken verschweißen</translation>
        </message>
        <message>
            <source>&amp;What bodies meet</source>
            <translation>Kolli&amp;sionskörper</translation>
        </message>
        <message>
            <source>&amp;Wireframe</source>
            <translation>&amp;Drahtgitter</translation>
        </message>
        <message>
            <source>&amp;y is up</source>
            <translation>&amp;y ist oben</translation>
        </message>
        <message>
            <source>&amp;z is up</source>
            <translation>&amp;z ist oben</translation>
        </message>
        <message>
            <source>+</source>
            <translation>+</translation>
        </message>
        <message>
            <source>, </source>
            <translation>, </translation>
        </message>
        <message>
            <source>, %1 N for ever</source>
            <translation>, dauerhaft %1 N</translation>
        </message>
        <message>
            <source>, about %1 min</source>
            <translation>, etwa %1 min</translation>
        </message>
        <message>
            <source>, but exact timers</source>
            <translation>, aber mit genauen Zeitgebern</translation>
        </message>
        <message>
            <source>, but slices of 0.1 ms and exact timers</source>
            <translation>, aber mit Zeitscheiben von 0.1 ms und genauen Zeitgebern</translation>
        </message>
        <message>
            <source>0 N</source>
            <translation>0 N</translation>
        </message>
        <message>
            <source>0.01 %</source>
            <translation>0.01 %</translation>
        </message>
        <message>
            <source>1 %</source>
            <translation>1 %</translation>
        </message>
        <message>
            <source>1 of 3: move the handle to the right</source>
            <translation>1 von 3: Griff nach rechts bewegen</translation>
        </message>
        <message>
            <source>1 triangle</source>
            <translation>1 Dreieck</translation>
        </message>
        <message>
            <source>1 unit is</source>
            <translation>1 Einheit ist</translation>
        </message>
        <message>
            <source>100 %</source>
            <translation>100 %</translation>
        </message>
        <message>
            <source>120 mm wide and 8 mm high</source>
            <translation>120 mm breit und 8 mm hoch</translation>
        </message>
        <message>
            <source>1280 x &amp;720</source>
            <translation>1280 x &amp;720</translation>
        </message>
        <message>
            <source>1920 x &amp;1080</source>
            <translation>1920 x &amp;1080</translation>
        </message>
        <message>
            <source>2 of 3: move the handle up</source>
            <translation>2 von 3: Griff nach oben bewegen</translation>
        </message>
        <message>
            <source>3 of 3: move the handle toward you</source>
            <translation>3 von 3: Griff zu sich hin bewegen</translation>
        </message>
        <message>
            <source>60 mm across and 80 mm high</source>
            <translation>60 mm Durchmesser und 80 mm hoch</translation>
        </message>
        <message>
            <source>99.9 % &lt; %1</source>
            <translation>99.9 % &lt; %1</translation>
        </message>
        <message>
            <source>: allow more with the lines "&lt;user&gt; - rtprio 90", "&lt;user&gt; - nice -15" and "&lt;user&gt; - memlock unlimited" in /etc/security/limits.d/tactum.conf, then log in again.</source>
            <translation>: Mehr erlauben mit den Zeilen "&lt;user&gt; - rtprio 90", "&lt;user&gt; - nice -15" und "&lt;user&gt; - memlock unlimited" in /etc/security/limits.d/tactum.conf und sich neu anmelden.</translation>
        </message>
        <message>
            <source>&lt;h3&gt;Tactum %1&lt;/h3&gt;&lt;p&gt;Gives the surfaces of 3-D models a feel, and lets you touch them. After Ruspini and Khatib, &lt;i&gt;Haptic Display for Human Interaction with Virtual Dynamic Environments&lt;/i&gt;, 2001.&lt;/p&gt;&lt;p&gt;BSD-3-Clause licence.&lt;/p&gt;</source>
            <translation>&lt;h3&gt;Tactum %1&lt;/h3&gt;&lt;p&gt;Gibt den Oberflächen von 3D-Modellen eine Haptik und lässt sie berühren. Nach Ruspini und Khatib, &lt;i&gt;Haptic Display for Human Interaction with Virtual Dynamic Environments&lt;/i&gt;, 2001.&lt;/p&gt;&lt;p&gt;Lizenz BSD-3-Clause.&lt;/p&gt;</translation>
        </message>
        <message>
            <source>A %1, B %2</source>
            <translation>A %1, B %2</translation>
        </message>
        <message>
            <source>A &amp;hundred times as high</source>
            <translation>&amp;Hundertmal so hoch</translation>
        </message>
        <message>
            <source>A &amp;loupe</source>
            <translation>Eine &amp;Lupe</translation>
        </message>
        <message>
            <source>A &amp;stylus</source>
            <translation>Ein St&amp;ift</translation>
        </message>
        <message>
            <source>A PNG, JPEG or TIFF picture of 8 or 16 bits; bright is high</source>
            <translation>Ein Bild in PNG, JPEG oder TIFF mit 8 oder 16 Bit; hell ist hoch</translation>
        </message>
        <message>
            <source>A ball of 60 mm</source>
            <translation>Eine Kugel von 60 mm</translation>
        </message>
        <message>
            <source>A bell on a rope, to be struck and held</source>
            <translation>Eine Glocke am Seil, zum Anschlagen und Festhalten</translation>
        </message>
        <message>
            <source>A brush that changes less</source>
            <translation>Ein Pinsel, der weniger ändert</translation>
        </message>
        <message>
            <source>A brush that changes more</source>
            <translation>Ein Pinsel, der mehr ändert</translation>
        </message>
        <message>
            <source>A button counts as held that nobody holds: look whether it is stuck.</source>
            <translation>Eine Taste gilt als gedrückt, die niemand drückt: nachsehen, ob sie klemmt.</translation>
        </message>
        <message>
            <source>A button of the device has ended all force.</source>
            <translation>Eine Taste des Geräts hat alle Kraft beendet.</translation>
        </message>
        <message>
            <source>A clic&amp;k takes the same colour</source>
            <translation>Klick wählt glei&amp;che Farbe</translation>
        </message>
        <message>
            <source>A click takes</source>
            <translation>Klick wählt</translation>
        </message>
        <message>
            <source>A click takes a surface; with Shift also, with Ctrl not any more</source>
            <translation>Ein Klick wählt eine Oberfläche; mit Umschalt zusätzlich, mit Strg nicht mehr</translation>
        </message>
        <message>
            <source>A click takes all that face the same &amp;way</source>
            <translation>Klick wählt gleiche Rich&amp;tung</translation>
        </message>
        <message>
            <source>A click takes all triangles that hang together over edges</source>
            <translation>Ein Klick wählt alle Dreiecke, die über Kanten zusammenhängen</translation>
        </message>
        <message>
            <source>A click takes every surface that feels like the one under the cursor</source>
            <translation>Ein Klick wählt jede Oberfläche, die sich anfühlt wie die unter dem Mauszeiger</translation>
        </message>
        <message>
            <source>A click takes every surface that has the colour of the one under the cursor</source>
            <translation>Ein Klick wählt jede Oberfläche, die die Farbe der Oberfläche unter dem Mauszeiger hat</translation>
        </message>
        <message>
            <source>A click takes every triangle of the object that faces the same way within the angle, connected or not</source>
            <translation>Ein Klick wählt jedes Dreieck des Objekts, das innerhalb des Winkels in dieselbe Richtung zeigt, zusammenhängend oder nicht</translation>
        </message>
        <message>
            <source>A click takes one triangle</source>
            <translation>Ein Klick wählt ein Dreieck</translation>
        </message>
        <message>
            <source>A click takes s&amp;imilar normals</source>
            <translation>Klick wählt ähnliche Nor&amp;malen</translation>
        </message>
        <message>
            <source>A click takes the &amp;connected region</source>
            <translation>Klick wählt &amp;zusammenhängendes Gebiet</translation>
        </message>
        <message>
            <source>A click takes the &amp;triangle</source>
            <translation>Klick wählt das &amp;Dreieck</translation>
        </message>
        <message>
            <source>A click takes the connected triangles that face the same way within the angle</source>
            <translation>Ein Klick wählt die zusammenhängenden Dreiecke, die innerhalb des Winkels in dieselbe Richtung zeigen</translation>
        </message>
        <message>
            <source>A click takes the s&amp;mooth region</source>
            <translation>Klick wählt g&amp;lattes Gebiet</translation>
        </message>
        <message>
            <source>A click takes the s&amp;urface</source>
            <translation>Klick wählt die &amp;Oberfläche</translation>
        </message>
        <message>
            <source>A click takes the same &amp;feel</source>
            <translation>Klick wählt gleiche &amp;Haptik</translation>
        </message>
        <message>
            <source>A click takes triangles up to edges that bend by more than the angle</source>
            <translation>Ein Klick wählt Dreiecke bis zu Kanten, die stärker knicken als der Winkel</translation>
        </message>
        <message>
            <source>A condition needs a name of its own, and there may be %1 of them.</source>
            <translation>Eine Bedingung braucht einen eigenen Namen, und es darf höchstens %1 geben.</translation>
        </message>
        <message>
            <source>A constraint plane of its own</source>
            <translation>Eine eigene Zwangsebene</translation>
        </message>
        <message>
            <source>A copy of the selected objects beside them, with their feel and what moves them</source>
            <translation>Eine Kopie der gewählten Objekte neben ihnen, mit ihrer Haptik und dem, was sie bewegt</translation>
        </message>
        <message>
            <source>A cube of 60 mm</source>
            <translation>Ein Würfel von 60 mm</translation>
        </message>
        <message>
            <source>A device is being made ready; wait for it, or give it up.</source>
            <translation>Ein Gerät wird bereit gemacht; darauf warten oder es aufgeben.</translation>
        </message>
        <message>
            <source>A door and two drawers with detents, friction and stops</source>
            <translation>Eine Tür und zwei Schubladen mit Rasten, Reibung und Anschlägen</translation>
        </message>
        <message>
            <source>A drag with the mouse</source>
            <translation>Ziehen mit der Maus</translation>
        </message>
        <message>
            <source>A flat face that feels like a relief, from one picture</source>
            <translation>Eine ebene Fläche, die sich wie ein Relief anfühlt, aus einem Bild</translation>
        </message>
        <message>
            <source>A gamepad shakes as the force does, with the mouse, a device or a recording: texture, slips and impacts</source>
            <translation>Ein Gamepad zittert wie die Kraft, mit der Maus, einem Gerät oder einer Aufzeichnung: Textur, Rutschen und Stöße</translation>
        </message>
        <message>
            <source>A gentle spring to the middle of the device's workspace, instead of the scene</source>
            <translation>Eine sanfte Feder zur Mitte des Geräte-Arbeitsraums, anstelle der Szene</translation>
        </message>
        <message>
            <source>A grid of 1, 10 or 100 mm beneath the scene, and the shadow that it casts there</source>
            <translation>Ein Raster von 1, 10 oder 100 mm unter der Szene und der Schatten, den sie dort wirft</translation>
        </message>
        <message>
            <source>A ground to put several models on</source>
            <translation>Ein Boden, auf den mehrere Modelle gestellt werden können</translation>
        </message>
        <message>
            <source>A hand has this device already.</source>
            <translation>Eine Hand hat dieses Gerät schon.</translation>
        </message>
        <message>
            <source>A joint of %1 away</source>
            <translation>Gelenk von %1 entfernen</translation>
        </message>
        <message>
            <source>A joint went with it.</source>
            <translation>Ein Gelenk wurde mit entfernt.</translation>
        </message>
        <message>
            <source>A knob turns the crank, and the crank drives a piston</source>
            <translation>Ein Knauf dreht die Kurbel, und die Kurbel treibt einen Kolben</translation>
        </message>
        <message>
            <source>A larger radius for the brush that paints, or the one that selects</source>
            <translation>Ein größerer Radius für den Pinsel, der malt, oder den, der auswählt</translation>
        </message>
        <message>
            <source>A layer like woven cloth on all selected surfaces</source>
            <translation>Eine Ebene wie gewebter Stoff auf allen gewählten Oberflächen</translation>
        </message>
        <message>
            <source>A layer of a PNG, JPEG or TIFF picture on all selected surfaces; bright is high</source>
            <translation>Eine Ebene aus einem Bild in PNG, JPEG oder TIFF auf allen gewählten Oberflächen; hell ist hoch</translation>
        </message>
        <message>
            <source>A layer of bumps and hollows, as high as its strength says</source>
            <translation>Eine Ebene aus Erhebungen und Mulden, so hoch, wie ihre Stärke angibt</translation>
        </message>
        <message>
            <source>A layer of bumps in rows on all selected surfaces</source>
            <translation>Eine Ebene aus Noppen in Reihen auf allen gewählten Oberflächen</translation>
        </message>
        <message>
            <source>A layer of noise on all selected surfaces</source>
            <translation>Eine Ebene aus Rauschen auf allen gewählten Oberflächen</translation>
        </message>
        <message>
            <source>A layer of parallel ridges on all selected surfaces</source>
            <translation>Eine Ebene aus parallelen Rippen auf allen gewählten Oberflächen</translation>
        </message>
        <message>
            <source>A layer that scales the dynamic friction</source>
            <translation>Eine Ebene, die die Gleitreibung skaliert</translation>
        </message>
        <message>
            <source>A layer that scales the static friction</source>
            <translation>Eine Ebene, die die Haftreibung skaliert</translation>
        </message>
        <message>
            <source>A layer that scales the stiffness</source>
            <translation>Eine Ebene, die die Steifigkeit skaliert</translation>
        </message>
        <message>
            <source>A layer that scales the viscosity</source>
            <translation>Eine Ebene, die die Viskosität skaliert</translation>
        </message>
        <message>
            <source>A lid on a hinge, which its own weight closes</source>
            <translation>Ein Deckel am Scharnier, den sein Gewicht schließt</translation>
        </message>
        <message>
            <source>A mass on flexures: stiff in one direction, soft in another</source>
            <translation>Eine Masse an Biegefedern: steif in einer Richtung, weich in der anderen</translation>
        </message>
        <message>
            <source>A motor that a finger can brake</source>
            <translation>Ein Motor, den ein Finger bremsen kann</translation>
        </message>
        <message>
            <source>A new path through the places of the model that are clicked, until this is clicked again</source>
            <translation>Eine neue Bahn durch die Stellen des Modells, die angeklickt werden, bis hier erneut geklickt wird</translation>
        </message>
        <message>
            <source>A pause</source>
            <translation>Eine Pause</translation>
        </message>
        <message>
            <source>A pen whose tip is the proxy, beside the ball; it leans toward the eye</source>
            <translation>Ein Stift, dessen Spitze der Proxy ist, neben der Kugel; er lehnt sich zum Auge</translation>
        </message>
        <message>
            <source>A picture becomes a layer of a surface: open a model first, and drop it there.</source>
            <translation>Ein Bild wird zu einer Ebene einer Oberfläche: zuerst ein Modell öffnen und es dort ablegen.</translation>
        </message>
        <message>
            <source>A place on the axis of the joint, in the world.</source>
            <translation>Ein Ort auf der Achse des Gelenks, in der Welt.</translation>
        </message>
        <message>
            <source>A plane with handles cuts the model in the view; what is felt and saved stays whole</source>
            <translation>Eine Ebene mit Griffen schneidet das Modell in der Ansicht auf; was gefühlt und gespeichert wird, bleibt ganz</translation>
        </message>
        <message>
            <source>A plate lies below the middle. Press on it and stroke: it holds, then lets go and slides.</source>
            <translation>Unter der Mitte liegt eine Platte. Darauf drücken und streichen: Sie hält, lässt dann los und gleitet.</translation>
        </message>
        <message>
            <source>A plate of 320 mm to put models on</source>
            <translation>Eine Platte von 320 mm, auf die Modelle gestellt werden</translation>
        </message>
        <message>
            <source>A plate that holds and slides, instead of the scene</source>
            <translation>Eine Platte, die hält und gleitet, anstelle der Szene</translation>
        </message>
        <message>
            <source>A recording is played: the device gets no force.</source>
            <translation>Eine Aufnahme wird abgespielt: Das Gerät erhält keine Kraft.</translation>
        </message>
        <message>
            <source>A recording is shown; end it first.</source>
            <translation>Eine Aufnahme wird gezeigt; sie zuerst beenden.</translation>
        </message>
        <message>
            <source>A rod with round ends.</source>
            <translation>Ein Stab mit runden Enden.</translation>
        </message>
        <message>
            <source>A round plate or rod with flat ends.</source>
            <translation>Eine runde Platte oder ein Stab mit flachen Enden.</translation>
        </message>
        <message>
            <source>A scene can have %1 cameras; remove one that is not used.</source>
            <translation>Eine Szene kann %1 Kameras haben; entfernen Sie eine, die nicht gebraucht wird.</translation>
        </message>
        <message>
            <source>A shape that the eye does not see: find it out with the finger</source>
            <translation>Eine Form, die das Auge nicht sieht: der Finger findet sie heraus</translation>
        </message>
        <message>
            <source>A simulated hand has no workspace to lay: the mouse leads it in the scene itself. Connect a device.</source>
            <translation>Eine simulierte Hand hat keinen Arbeitsraum, der zu legen wäre: Die Maus führt sie in der Szene selbst. Ein Gerät verbinden.</translation>
        </message>
        <message>
            <source>A simulated hand needs no stop: Esc ends its force as well.</source>
            <translation>Eine simulierte Hand braucht keinen Stopp: Esc beendet auch ihre Kraft.</translation>
        </message>
        <message>
            <source>A smaller radius for the brush that paints, or the one that selects</source>
            <translation>Ein kleinerer Radius für den Pinsel, der malt, oder den, der auswählt</translation>
        </message>
        <message>
            <source>A stiff wall stands to the right of the middle. Push against it: it holds and does not buzz.</source>
            <translation>Rechts der Mitte steht eine steife Wand. Dagegendrücken: Sie hält und brummt nicht.</translation>
        </message>
        <message>
            <source>A stiff wall, instead of the scene</source>
            <translation>Eine steife Wand, anstelle der Szene</translation>
        </message>
        <message>
            <source>A tenth of the pace; the hand keeps its own</source>
            <translation>Ein Zehntel des Tempos; die Hand behält ihr eigenes</translation>
        </message>
        <message>
            <source>A thin line where one surface ends and another begins</source>
            <translation>Eine dünne Linie, wo eine Oberfläche endet und eine andere beginnt</translation>
        </message>
        <message>
            <source>A video has 1280 x 720 pixels</source>
            <translation>Ein Video hat 1280 x 720 Pixel</translation>
        </message>
        <message>
            <source>A video has 1920 x 1080 pixels</source>
            <translation>Ein Video hat 1920 x 1080 Pixel</translation>
        </message>
        <message>
            <source>A video has the size of the view</source>
            <translation>Ein Video hat die Größe der Ansicht</translation>
        </message>
        <message>
            <source>A whole hand calms the device, so that surfaces may be up to 1.7 times as stiff. Held more loosely than said they may shake: after three times the light grip is assumed again, until you choose anew. It is remembered for this device.</source>
            <translation>Eine ganze Hand beruhigt das Gerät, sodass Oberflächen bis zu 1.7-mal so steif sein dürfen. Wird der Griff lockerer gehalten als angegeben, können sie zittern: Nach dem dritten Mal gilt wieder lockeres Halten, bis Sie neu wählen. Es wird für dieses Gerät gemerkt.</translation>
        </message>
        <message>
            <source>A window on the scene and the device of a haptic server</source>
            <translation>Ein Fenster auf die Szene und das Gerät eines haptischen Servers</translation>
        </message>
        <message>
            <source>A&amp;dd</source>
            <translation>&amp;Hinzufügen</translation>
        </message>
        <message>
            <source>A&amp;lign and distribute</source>
            <translation>Ausri&amp;chten und verteilen</translation>
        </message>
        <message>
            <source>A&amp;xes of the handles</source>
            <translation>A&amp;chsen der Anfasser</translation>
        </message>
        <message>
            <source>A/B/X</source>
            <translation>A/B/X</translation>
        </message>
        <message>
            <source>A/B/X: which one is X?</source>
            <translation>A/B/X: Welches ist X?</translation>
        </message>
        <message>
            <source>A: as marked</source>
            <translation>A: wie markiert</translation>
        </message>
        <message>
            <source>About Tactum</source>
            <translation>Über Tactum</translation>
        </message>
        <message>
            <source>About what o&amp;bjects turn</source>
            <translation>&amp;Drehpunkt der Objekte</translation>
        </message>
        <message>
            <source>About what objects turn and scale</source>
            <translation>Worum Objekte gedreht und skaliert werden</translation>
        </message>
        <message>
            <source>Above the ceiling the device may shake or push your hand away. Hold it firmly, and keep Esc in reach: held for half a second it ends all force.</source>
            <translation>Oberhalb der Steifigkeitsgrenze kann das Gerät zittern oder Ihre Hand wegstoßen. Fest halten und Esc in Reichweite behalten: Eine halbe Sekunde gehalten beendet es alle Kraft.</translation>
        </message>
        <message>
            <source>Above the layer that lies on it</source>
            <translation>Über die Ebene, die auf ihr liegt</translation>
        </message>
        <message>
            <source>Across &amp;x</source>
            <translation>Quer zu &amp;x</translation>
        </message>
        <message>
            <source>Across &amp;y</source>
            <translation>Quer zu &amp;y</translation>
        </message>
        <message>
            <source>Across &amp;z</source>
            <translation>Quer zu &amp;z</translation>
        </message>
        <message>
            <source>Add</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <source>Add %1</source>
            <translation>%1 hinzufügen</translation>
        </message>
        <message>
            <source>Add &amp;dots</source>
            <translation>&amp;Noppen hinzufügen</translation>
        </message>
        <message>
            <source>Add &amp;grooves</source>
            <translation>Ri&amp;llen hinzufügen</translation>
        </message>
        <message>
            <source>Add &amp;noise</source>
            <translation>&amp;Rauschen hinzufügen</translation>
        </message>
        <message>
            <source>Add &amp;weave</source>
            <translation>&amp;Gewebe hinzufügen</translation>
        </message>
        <message>
            <source>Add a device</source>
            <translation>Gerät hinzufügen</translation>
        </message>
        <message>
            <source>Add a layer</source>
            <translation>Ebene hinzufügen</translation>
        </message>
        <message>
            <source>Add a layer to all selected surfaces</source>
            <translation>Allen gewählten Oberflächen eine Ebene hinzufügen</translation>
        </message>
        <message>
            <source>Add a pain&amp;ted layer</source>
            <translation>Ge&amp;malte Ebene hinzufügen</translation>
        </message>
        <message>
            <source>Add an &amp;image...</source>
            <translation>&amp;Bild hinzufügen...</translation>
        </message>
        <message>
            <source>Add models</source>
            <translation>Modelle hinzufügen</translation>
        </message>
        <message>
            <source>Add the selection to</source>
            <translation>Die Auswahl hinzufügen zu</translation>
        </message>
        <message>
            <source>Add to the set %1</source>
            <translation>Zum Satz %1 hinzufügen</translation>
        </message>
        <message>
            <source>Adding</source>
            <translation>Hinzufügen</translation>
        </message>
        <message>
            <source>Additional tangential force for each metre per second of sliding: the b of equation 21.</source>
            <translation>Zusätzliche Tangentialkraft für jeden Meter je Sekunde des Gleitens: das b der Gleichung 21.</translation>
        </message>
        <message>
            <source>After &amp;each edit</source>
            <translation>Nach jeder Än&amp;derung</translation>
        </message>
        <message>
            <source>After each edit</source>
            <translation>Nach jeder Änderung</translation>
        </message>
        <message>
            <source>Agree on fronts</source>
            <translation>Vorderseiten angleichen</translation>
        </message>
        <message>
            <source>Air</source>
            <translation>Luft</translation>
        </message>
        <message>
            <source>Align</source>
            <translation>Ausrichten</translation>
        </message>
        <message>
            <source>Align &amp;back sides</source>
            <translation>&amp;Hintere Seiten ausrichten</translation>
        </message>
        <message>
            <source>Align &amp;front sides</source>
            <translation>&amp;Vordere Seiten ausrichten</translation>
        </message>
        <message>
            <source>Align &amp;left sides</source>
            <translation>&amp;Linke Seiten ausrichten</translation>
        </message>
        <message>
            <source>Align &amp;right sides</source>
            <translation>&amp;Rechte Seiten ausrichten</translation>
        </message>
        <message>
            <source>Align l&amp;ower sides</source>
            <translation>U&amp;ntere Seiten ausrichten</translation>
        </message>
        <message>
            <source>Align middles along &amp;x</source>
            <translation>Mitten entlang &amp;x ausrichten</translation>
        </message>
        <message>
            <source>Align middles along &amp;y</source>
            <translation>Mitten entlang &amp;y ausrichten</translation>
        </message>
        <message>
            <source>Align middles along &amp;z</source>
            <translation>Mitten entlang &amp;z ausrichten</translation>
        </message>
        <message>
            <source>Align u&amp;pper sides</source>
            <translation>Ob&amp;ere Seiten ausrichten</translation>
        </message>
        <message>
            <source>All keys on one page</source>
            <translation>Alle Tasten auf einer Seite</translation>
        </message>
        <message>
            <source>All objects</source>
            <translation>Alle Objekte</translation>
        </message>
        <message>
            <source>All objects of the groups that something is selected of; a double click on an object does the same</source>
            <translation>Alle Objekte der Gruppen, von denen etwas ausgewählt ist; ein Doppelklick auf ein Objekt tut dasselbe</translation>
        </message>
        <message>
            <source>All of %1 went, not its selected surfaces alone.</source>
            <translation>%1 wurde ganz gelöscht, nicht nur die gewählten Oberflächen.</translation>
        </message>
        <message>
            <source>All surfaces</source>
            <translation>Alle Oberflächen</translation>
        </message>
        <message>
            <source>Along a ruler</source>
            <translation>An einem Lineal entlang</translation>
        </message>
        <message>
            <source>Along its own axes.</source>
            <translation>Entlang der eigenen Achsen.</translation>
        </message>
        <message>
            <source>Along x of the world</source>
            <translation>Entlang x der Welt</translation>
        </message>
        <message>
            <source>Along y of the world</source>
            <translation>Entlang y der Welt</translation>
        </message>
        <message>
            <source>Along z of the world</source>
            <translation>Entlang z der Welt</translation>
        </message>
        <message>
            <source>Also under View &gt; Look &gt; Theme.</source>
            <translation>Auch unter Ansicht &gt; Darstellungsweise &gt; Design.</translation>
        </message>
        <message>
            <source>Alt+1 to Alt+9</source>
            <translation>Alt+1 bis Alt+9</translation>
        </message>
        <message>
            <source>Aluminium on steel</source>
            <translation>Aluminium auf Stahl</translation>
        </message>
        <message>
            <source>An edit that is not saved is in the recovery journal after this time at the latest. The first edits are after two seconds.</source>
            <translation>Eine Änderung, die nicht gespeichert ist, steht spätestens nach dieser Zeit im Wiederherstellungs-Journal. Die ersten Änderungen schon nach zwei Sekunden.</translation>
        </message>
        <message>
            <source>An empty layer to be painted on all selected surfaces</source>
            <translation>Eine leere Ebene zum Bemalen auf allen gewählten Oberflächen</translation>
        </message>
        <message>
            <source>An empty scene, to add models to</source>
            <translation>Eine leere Szene, der Modelle hinzugefügt werden</translation>
        </message>
        <message>
            <source>An estimate from the forces so far; 100 % is what the motors bear for ever. From 70 % on the limit falls to the continuous force.</source>
            <translation>Eine Schätzung aus den bisherigen Kräften; 100 % ist, was die Motoren dauerhaft aushalten. Ab 70 % sinkt die Grenze auf die Dauerkraft.</translation>
        </message>
        <message>
            <source>An object can have %1 sets, and not too many scattered ones; remove one that is not used.</source>
            <translation>Ein Objekt kann %1 Sätze haben, und nicht zu viele verstreute; bitte einen entfernen, der nicht gebraucht wird.</translation>
        </message>
        <message>
            <source>An oscillation was seen: the stiffness was halved.</source>
            <translation>Eine Schwingung wurde erkannt: Die Steifigkeit wurde halbiert.</translation>
        </message>
        <message>
            <source>Angle</source>
            <translation>Winkel</translation>
        </message>
        <message>
            <source>Angle %1</source>
            <translation>Winkel %1</translation>
        </message>
        <message>
            <source>Another colour for the selected surfaces, to be seen by; what is felt stays</source>
            <translation>Eine andere Farbe für die gewählten Flächen, nur fürs Auge; was gefühlt wird, bleibt</translation>
        </message>
        <message>
            <source>Another colour for the selected surfaces. It is only seen.</source>
            <translation>Eine andere Farbe für die gewählten Flächen. Sie wird nur gesehen.</translation>
        </message>
        <message>
            <source>Another hand has this device; remove that hand first.</source>
            <translation>Eine andere Hand hat dieses Gerät; zuerst diese Hand entfernen.</translation>
        </message>
        <message>
            <source>Another name for the object or surface that was selected last</source>
            <translation>Ein anderer Name für das zuletzt gewählte Objekt oder die zuletzt gewählte Oberfläche</translation>
        </message>
        <message>
            <source>Another number gives another noise of the same kind.</source>
            <translation>Eine andere Zahl ergibt ein anderes Rauschen derselben Art.</translation>
        </message>
        <message>
            <source>Another order</source>
            <translation>Andere Reihenfolge</translation>
        </message>
        <message>
            <source>Another window has taken that scene.</source>
            <translation>Ein anderes Fenster hat diese Szene übernommen.</translation>
        </message>
        <message>
            <source>Another window opens on the server's scene and device. A server on another machine needs certificate.pem and token, which tactum serve --make-certificate has made there.</source>
            <translation>Ein weiteres Fenster öffnet sich auf die Szene und das Gerät des Servers. Ein Server auf einem anderen Rechner braucht certificate.pem und token, die tactum serve --make-certificate dort angelegt hat.</translation>
        </message>
        <message>
            <source>Answer</source>
            <translation>Antwort</translation>
        </message>
        <message>
            <source>Answers and touch are logged as CSV; Esc ends it</source>
            <translation>Antworten und Berührung werden als CSV protokolliert; Esc beendet es</translation>
        </message>
        <message>
            <source>Apply</source>
            <translation>Anwenden</translation>
        </message>
        <message>
            <source>Apply the p&amp;reset</source>
            <translation>Vor&amp;gabe anwenden</translation>
        </message>
        <message>
            <source>Arm</source>
            <translation>Kräfte an</translation>
        </message>
        <message>
            <source>Arm again</source>
            <translation>Kräfte wieder an</translation>
        </message>
        <message>
            <source>Arrows, Page Up, Page Down</source>
            <translation>Pfeiltasten, Bild auf, Bild ab</translation>
        </message>
        <message>
            <source>As at %1</source>
            <translation>Wie auf %1</translation>
        </message>
        <message>
            <source>As hard as can be</source>
            <translation>So hart wie möglich</translation>
        </message>
        <message>
            <source>As high as they are &amp;felt</source>
            <translation>So hoch wie ge&amp;fühlt</translation>
        </message>
        <message>
            <source>As if it were wrapped tightly: hollows are filled.</source>
            <translation>Wie eng umwickelt: Mulden werden gefüllt.</translation>
        </message>
        <message>
            <source>As large as the &amp;view</source>
            <translation>So &amp;groß wie die Ansicht</translation>
        </message>
        <message>
            <source>As listed</source>
            <translation>Wie aufgelistet</translation>
        </message>
        <message>
            <source>As opened</source>
            <translation>Wie geöffnet</translation>
        </message>
        <message>
            <source>As what other bodies meet it; View &gt; What bodies meet draws it.</source>
            <translation>Form, in der andere Körper ihm begegnen; Ansicht &gt; Kollisionskörper zeichnet sie.</translation>
        </message>
        <message>
            <source>As what others meet it</source>
            <translation>Form, in der andere ihm begegnen</translation>
        </message>
        <message>
            <source>Ask again at the next start</source>
            <translation>Beim nächsten Start erneut fragen</translation>
        </message>
        <message>
            <source>Ask to edit</source>
            <translation>Bearbeiten anfragen</translation>
        </message>
        <message>
            <source>Asks for the pen, which one client has at a time. Stop needs none</source>
            <translation>Bittet um den Stift, den jeweils ein Client hat. Stopp braucht keinen</translation>
        </message>
        <message>
            <source>At %1 %2.</source>
            <translation>Auf %1: %2.</translation>
        </message>
        <message>
            <source>At 1 a vibration of 1 N turns a motor with all it has, at 4 one of 0.25 N. Device &gt; Gamepad switches it on.</source>
            <translation>Bei 1 dreht eine Vibration von 1 N einen Motor so stark, wie er kann, bei 4 eine von 0.25 N. Gerät &gt; Gamepad schaltet sie ein.</translation>
        </message>
        <message>
            <source>At least %1</source>
            <translation>Mindestens %1</translation>
        </message>
        <message>
            <source>At most %1</source>
            <translation>Höchstens %1</translation>
        </message>
        <message>
            <source>At most %1 N</source>
            <translation>Höchstens %1 N</translation>
        </message>
        <message numerus="yes">
            <source>At most %n trial(s)</source>
            <translation>
                <numerusform>Höchstens %n Durchgang</numerusform>
                <numerusform>Höchstens %n Durchgänge</numerusform>
            </translation>
        </message>
        <message>
            <source>At most trials</source>
            <translation>Höchstens Durchgänge</translation>
        </message>
        <message>
            <source>At once</source>
            <translation>Sofort</translation>
        </message>
        <message>
            <source>At x</source>
            <translation>Bei x</translation>
        </message>
        <message>
            <source>At y</source>
            <translation>Bei y</translation>
        </message>
        <message>
            <source>At z</source>
            <translation>Bei z</translation>
        </message>
        <message>
            <source>Axes of the handles</source>
            <translation>Achsen der Anfasser</translation>
        </message>
        <message>
            <source>Axis</source>
            <translation>Achse</translation>
        </message>
        <message>
            <source>Axis and place as the form of the object suggests them; again: the next likely ones</source>
            <translation>Achse und Lage, wie die Form des Objekts sie nahelegt; erneut: die nächstwahrscheinlichen</translation>
        </message>
        <message>
            <source>B&amp;rush</source>
            <translation>&amp;Pinsel</translation>
        </message>
        <message>
            <source>B: as it is now</source>
            <translation>B: wie es jetzt ist</translation>
        </message>
        <message>
            <source>Back</source>
            <translation>Hinten</translation>
        </message>
        <message>
            <source>Back</source>
            <comment>to the page before</comment>
            <translation>Zurück</translation>
        </message>
        <message>
            <source>Back to live</source>
            <translation>Zurück zu Live</translation>
        </message>
        <message>
            <source>Back to my scene</source>
            <translation>Zurück zu meiner Szene</translation>
        </message>
        <message>
            <source>Back to the default, %1</source>
            <translation>Zurück zum Standard, %1</translation>
        </message>
        <message>
            <source>Balanced Latin square</source>
            <translation>Balanciertes lateinisches Quadrat</translation>
        </message>
        <message>
            <source>Begin (Space)</source>
            <translation>Beginnen (Leertaste)</translation>
        </message>
        <message>
            <source>Beneath the layer that it lies on</source>
            <translation>Unter die Ebene, auf der sie liegt</translation>
        </message>
        <message>
            <source>Beyond the shell: the workspace moves.</source>
            <translation>Außerhalb der Schale: Der Arbeitsraum bewegt sich.</translation>
        </message>
        <message>
            <source>Blend</source>
            <translation>Mischen</translation>
        </message>
        <message>
            <source>Body</source>
            <translation>Körper</translation>
        </message>
        <message>
            <source>Body energy</source>
            <translation>Körperenergie</translation>
        </message>
        <message>
            <source>Both</source>
            <translation>Beide</translation>
        </message>
        <message>
            <source>Both forces of each step of the stroke</source>
            <translation>Beide Kräfte jedes Schritts des Strichs</translation>
        </message>
        <message>
            <source>Both touches were written to %1.</source>
            <translation>Beide Berührungen wurden nach %1 geschrieben.</translation>
        </message>
        <message>
            <source>Bottom</source>
            <translation>Unten</translation>
        </message>
        <message>
            <source>Box</source>
            <translation>Box</translation>
        </message>
        <message>
            <source>Box and lasso also take what lies behind; else what is seen, as the brush does</source>
            <translation>Box und Lasso wählen auch, was dahinter liegt; sonst, was zu sehen ist, wie der Pinsel</translation>
        </message>
        <message>
            <source>Brick</source>
            <translation>Ziegel</translation>
        </message>
        <message>
            <source>Brick, tiles, weave and sandpaper, from pictures and formulas</source>
            <translation>Ziegel, Fliesen, Gewebe und Schleifpapier, aus Bildern und Formeln</translation>
        </message>
        <message>
            <source>Bring %1 back</source>
            <translation>%1 zurückholen</translation>
        </message>
        <message>
            <source>Bring it back</source>
            <translation>Zurückholen</translation>
        </message>
        <message>
            <source>Bring the finger to the middle. From there a gentle spring draws it back, wherever you go.</source>
            <translation>Finger zur Mitte bringen. Von dort zieht eine sanfte Feder ihn zurück, wohin er auch geht.</translation>
        </message>
        <message>
            <source>Bumps as high as they are felt</source>
            <translation>Erhebungen so hoch wie gefühlt</translation>
        </message>
        <message>
            <source>Bumps drawn %1 times as high as they are felt</source>
            <translation>Erhebungen %1-mal so hoch gezeichnet wie gefühlt</translation>
        </message>
        <message>
            <source>Bumps: no surface here has a height layer</source>
            <translation>Erhebungen: keine Oberfläche hier hat eine Höhenebene</translation>
        </message>
        <message>
            <source>Bundles</source>
            <translation>Bündel</translation>
        </message>
        <message>
            <source>Bundles as zip</source>
            <translation>Bündel als zip</translation>
        </message>
        <message>
            <source>Button %1</source>
            <translation>Taste %1</translation>
        </message>
        <message>
            <source>Button %1 of %2 was not heard.</source>
            <translation>Taste %1 von %2 war nicht zu hören.</translation>
        </message>
        <message>
            <source>Button %1 was not heard to be released.</source>
            <translation>Taste %1 war beim Loslassen nicht zu hören.</translation>
        </message>
        <message>
            <source>Button that ends all force</source>
            <translation>Taste, die alle Kraft beendet</translation>
        </message>
        <message>
            <source>Buttons</source>
            <translation>Tasten</translation>
        </message>
        <message>
            <source>Cancel</source>
            <translation>Abbrechen</translation>
        </message>
        <message>
            <source>Capsule</source>
            <translation>Kapsel</translation>
        </message>
        <message>
            <source>Category</source>
            <translation>Kategorie</translation>
        </message>
        <message>
            <source>Ceiling</source>
            <translation>Grenze</translation>
        </message>
        <message>
            <source>Ceiling, the red tick: %1 N/m, %2</source>
            <translation>Steifigkeitsgrenze, die rote Marke: %1 N/m, %2</translation>
        </message>
        <message>
            <source>Centimetres</source>
            <translation>Zentimeter</translation>
        </message>
        <message>
            <source>Centred, and scaled so that the device's workspace takes in the model</source>
            <translation>Zentriert und so skaliert, dass der Arbeitsraum des Geräts das Modell aufnimmt</translation>
        </message>
        <message>
            <source>Centred, and scaled so that the workspace takes in the model</source>
            <translation>Zentriert und so skaliert, dass der Arbeitsraum das Modell aufnimmt</translation>
        </message>
        <message>
            <source>Change</source>
            <translation>Ändern</translation>
        </message>
        <message>
            <source>Changed by %1</source>
            <translation>Geändert von %1</translation>
        </message>
        <message>
            <source>Changed by another program</source>
            <translation>Von einem anderen Programm geändert</translation>
        </message>
        <message>
            <source>Changed since by another program</source>
            <translation>Seither von einem anderen Programm geändert</translation>
        </message>
        <message>
            <source>Changes</source>
            <translation>Ändert</translation>
        </message>
        <message>
            <source>Changing the mesh</source>
            <translation>Netz wird geändert</translation>
        </message>
        <message>
            <source>Choice asked</source>
            <translation>Frage zur Wahl</translation>
        </message>
        <message>
            <source>Choose %1...</source>
            <translation>%1 wählen...</translation>
        </message>
        <message>
            <source>Choose a device in the list first.</source>
            <translation>Zuerst ein Gerät in der Liste wählen.</translation>
        </message>
        <message>
            <source>Choose a picture</source>
            <translation>Bild wählen</translation>
        </message>
        <message>
            <source>Choose...</source>
            <translation>Wählen...</translation>
        </message>
        <message>
            <source>Clear</source>
            <translation>Löschen</translation>
        </message>
        <message>
            <source>Clear the m&amp;easure</source>
            <translation>Maß &amp;löschen</translation>
        </message>
        <message>
            <source>Click a step to go back or forth to it; the disk marks what is saved</source>
            <translation>Einen Schritt anklicken, um zu ihm zurück- oder vorzugehen; die Diskette markiert, was gespeichert ist</translation>
        </message>
        <message>
            <source>Click a surface in the view (Q) or in the outliner to see and set how it feels.</source>
            <translation>Eine Oberfläche in der Ansicht (Q) oder in der Szenenliste anklicken, um zu sehen und festzulegen, wie sie sich anfühlt.</translation>
        </message>
        <message>
            <source>Close</source>
            <translation>Schließen</translation>
        </message>
        <message>
            <source>Close (Space)</source>
            <translation>Schließen (Leertaste)</translation>
        </message>
        <message>
            <source>Close the holes whose rim is simple; wide openings stay.</source>
            <translation>Die Löcher schließen, deren Rand einfach ist; weite Öffnungen bleiben.</translation>
        </message>
        <message>
            <source>Close the recording and go on with the open model</source>
            <translation>Aufnahme schließen und mit dem offenen Modell weitermachen</translation>
        </message>
        <message>
            <source>Close this message</source>
            <translation>Diese Meldung schließen</translation>
        </message>
        <message>
            <source>Close: unit and up axis are right</source>
            <translation>Schließen: Einheit und Hochachse stimmen</translation>
        </message>
        <message>
            <source>Closed</source>
            <translation>Geschlossen</translation>
        </message>
        <message>
            <source>Clutch</source>
            <translation>Kupplung</translation>
        </message>
        <message>
            <source>Colo&amp;ur map</source>
            <translation>Far&amp;bkarte</translation>
        </message>
        <message>
            <source>Colo&amp;ur...</source>
            <translation>&amp;Farbe...</translation>
        </message>
        <message>
            <source>Colour</source>
            <translation>Farbe</translation>
        </message>
        <message>
            <source>Colour of %1</source>
            <translation>Farbe von %1</translation>
        </message>
        <message>
            <source>Colours the surfaces by the sum of their height layers</source>
            <translation>Färbt die Oberflächen nach der Summe ihrer Höhenebenen</translation>
        </message>
        <message>
            <source>Colours the surfaces by their damping</source>
            <translation>Färbt die Oberflächen nach ihrer Dämpfung</translation>
        </message>
        <message>
            <source>Colours the surfaces by their dynamic friction, as their layers make it</source>
            <translation>Färbt die Oberflächen nach ihrer Gleitreibung, wie ihre Ebenen sie machen</translation>
        </message>
        <message>
            <source>Colours the surfaces by their static friction, as their layers make it</source>
            <translation>Färbt die Oberflächen nach ihrer Haftreibung, wie ihre Ebenen sie machen</translation>
        </message>
        <message>
            <source>Colours the surfaces by their stiffness</source>
            <translation>Färbt die Oberflächen nach ihrer Steifigkeit</translation>
        </message>
        <message>
            <source>Colours the surfaces by their viscosity</source>
            <translation>Färbt die Oberflächen nach ihrer Viskosität</translation>
        </message>
        <message>
            <source>Come nearer to the model</source>
            <translation>Näher an das Modell herangehen</translation>
        </message>
        <message>
            <source>Comes nearer</source>
            <translation>Geht näher</translation>
        </message>
        <message>
            <source>Commands</source>
            <translation>Befehle</translation>
        </message>
        <message>
            <source>Commands that fit</source>
            <translation>Passende Befehle</translation>
        </message>
        <message>
            <source>Compare</source>
            <translation>Vergleich</translation>
        </message>
        <message>
            <source>Comparing...</source>
            <translation>Wird verglichen...</translation>
        </message>
        <message>
            <source>Conditions of the study</source>
            <translation>Bedingungen der Studie</translation>
        </message>
        <message>
            <source>Connect</source>
            <translation>Verbinden</translation>
        </message>
        <message>
            <source>Connect to a haptic server</source>
            <translation>Mit einem haptischen Server verbinden</translation>
        </message>
        <message>
            <source>Connected</source>
            <translation>Zusammenhängend</translation>
        </message>
        <message>
            <source>Contents</source>
            <translation>Inhalt</translation>
        </message>
        <message>
            <source>Convex parts</source>
            <translation>Konvexe Teile</translation>
        </message>
        <message>
            <source>Copper on steel</source>
            <translation>Kupfer auf Stahl</translation>
        </message>
        <message>
            <source>Copy</source>
            <translation>Kopieren</translation>
        </message>
        <message>
            <source>Copy the feel of a surface first (Ctrl+C).</source>
            <translation>Zuerst die Haptik einer Oberfläche kopieren (Strg+C).</translation>
        </message>
        <message>
            <source>Cork</source>
            <translation>Kork</translation>
        </message>
        <message>
            <source>Corrugated cardboard</source>
            <translation>Wellpappe</translation>
        </message>
        <message>
            <source>Counts from the next start on.</source>
            <translation>Gilt ab dem nächsten Start.</translation>
        </message>
        <message>
            <source>Crease angle</source>
            <translation>Knickwinkel</translation>
        </message>
        <message>
            <source>Ctrl snaps to 5 mm, 15 degrees and 0.1, Shift is ten times finer, Esc or the right button gives it up</source>
            <translation>Strg rastet auf 5 mm, 15 Grad und 0.1 ein, Umschalt ist zehnmal feiner, Esc oder die rechte Taste bricht ab</translation>
        </message>
        <message>
            <source>Ctrl snaps, Shift is fine, Esc gives up</source>
            <translation>Strg rastet ein, Umschalt ist fein, Esc bricht ab</translation>
        </message>
        <message>
            <source>Cut across</source>
            <translation>Schnitt quer zu</translation>
        </message>
        <message>
            <source>Cut across the x axis, in the middle</source>
            <translation>Schnitt quer zur x-Achse, in der Mitte</translation>
        </message>
        <message>
            <source>Cut across the y axis, in the middle</source>
            <translation>Schnitt quer zur y-Achse, in der Mitte</translation>
        </message>
        <message>
            <source>Cut across the z axis, in the middle</source>
            <translation>Schnitt quer zur z-Achse, in der Mitte</translation>
        </message>
        <message>
            <source>Cylinder</source>
            <translation>Zylinder</translation>
        </message>
        <message>
            <source>Cylindrical</source>
            <translation>Zylindrisch</translation>
        </message>
        <message>
            <source>D&amp;elete</source>
            <translation>&amp;Löschen</translation>
        </message>
        <message>
            <source>D&amp;isconnect</source>
            <translation>T&amp;rennen</translation>
        </message>
        <message>
            <source>D&amp;istribute along y</source>
            <translation>Gleich&amp;mäßig entlang y verteilen</translation>
        </message>
        <message>
            <source>D&amp;uplicate layer</source>
            <translation>Ebene &amp;duplizieren</translation>
        </message>
        <message>
            <source>D&amp;ynamic friction</source>
            <translation>&amp;Gleitreibung</translation>
        </message>
        <message>
            <source>Damping</source>
            <translation>Dämpfung</translation>
        </message>
        <message>
            <source>Damping now</source>
            <translation>Dämpfung jetzt</translation>
        </message>
        <message>
            <source>Damping that takes such energy back, now. 0: the surface is passive by itself.</source>
            <translation>Dämpfung, die solche Energie gerade zurücknimmt. 0: Die Oberfläche ist von selbst passiv.</translation>
        </message>
        <message>
            <source>Dark</source>
            <translation>Dunkel</translation>
        </message>
        <message>
            <source>Dark figures on light grey</source>
            <translation>Dunkle Figuren auf Hellgrau</translation>
        </message>
        <message>
            <source>Dark or light as the desktop is</source>
            <translation>Dunkel oder hell, wie der Desktop ist</translation>
        </message>
        <message>
            <source>Darken (minimum)</source>
            <translation>Abdunkeln (Minimum)</translation>
        </message>
        <message>
            <source>Del, Ctrl+D, Alt+Up, Alt+Down</source>
            <translation>Entf, Strg+D, Alt+Auf, Alt+Ab</translation>
        </message>
        <message>
            <source>Deleted when the program ends; until then it can be brought back</source>
            <translation>Wird bei Programmende gelöscht; bis dahin kann es zurückgeholt werden</translation>
        </message>
        <message>
            <source>Denim</source>
            <translation>Jeansstoff</translation>
        </message>
        <message>
            <source>Density of what bodies move through, which slows them by the square of their speed: 1.2 is air, 1000 water, 0 nothing.</source>
            <translation>Dichte dessen, worin sich Körper bewegen und was sie mit dem Quadrat ihrer Geschwindigkeit bremst: 1.2 ist Luft, 1000 Wasser, 0 nichts.</translation>
        </message>
        <message>
            <source>Detent force</source>
            <translation>Rastkraft</translation>
        </message>
        <message>
            <source>Detent torque</source>
            <translation>Rastmoment</translation>
        </message>
        <message>
            <source>Detents every</source>
            <translation>Raste alle</translation>
        </message>
        <message>
            <source>Deutsch</source>
            <translation>Deutsch</translation>
        </message>
        <message>
            <source>Deviations of the servo's period</source>
            <translation>Abweichungen der Servoperiode</translation>
        </message>
        <message>
            <source>Device</source>
            <translation>Gerät</translation>
        </message>
        <message>
            <source>Did you feel it?</source>
            <translation>Haben Sie es gefühlt?</translation>
        </message>
        <message>
            <source>Difference B - A</source>
            <translation>Differenz B - A</translation>
        </message>
        <message>
            <source>Difference: %1</source>
            <translation>Differenz: %1</translation>
        </message>
        <message>
            <source>Dis&amp;tribute along z</source>
            <translation>Gleichmäßig entlang z ver&amp;teilen</translation>
        </message>
        <message>
            <source>Disconnect</source>
            <translation>Trennen</translation>
        </message>
        <message>
            <source>Distance %1</source>
            <translation>Abstand %1</translation>
        </message>
        <message>
            <source>Distribute</source>
            <translation>Verteilen</translation>
        </message>
        <message>
            <source>Do the last undone edit again</source>
            <translation>Die zuletzt rückgängig gemachte Änderung wiederholen</translation>
        </message>
        <message>
            <source>Dots</source>
            <translation>Noppen</translation>
        </message>
        <message>
            <source>Dr&amp;op to the ground</source>
            <translation>Auf den &amp;Boden setzen</translation>
        </message>
        <message>
            <source>Drag a preset onto the model, or choose one and press Enter: it is given to the selected surfaces.</source>
            <translation>Eine Vorgabe auf das Modell ziehen oder eine wählen und Eingabe drücken: Die gewählten Oberflächen erhalten sie.</translation>
        </message>
        <message>
            <source>Drag a row to put it above or below others; double click to rename</source>
            <translation>Eine Zeile ziehen, um sie über oder unter andere zu legen; Doppelklick zum Umbenennen</translation>
        </message>
        <message>
            <source>Drag of a handle</source>
            <translation>Ziehen eines Anfassers</translation>
        </message>
        <message>
            <source>Drag on the model</source>
            <translation>Ziehen auf dem Modell</translation>
        </message>
        <message>
            <source>Drag on the model to touch it</source>
            <translation>Zum Berühren auf dem Modell ziehen</translation>
        </message>
        <message>
            <source>Drag on the model, paint tool</source>
            <translation>Ziehen auf dem Modell, Werkzeug Malen</translation>
        </message>
        <message>
            <source>Drag the finger</source>
            <translation>Finger ziehen</translation>
        </message>
        <message>
            <source>Drag, select tool with the brush</source>
            <translation>Ziehen, Werkzeug Auswählen mit dem Pinsel</translation>
        </message>
        <message>
            <source>Drags take what they go over, until Esc or C again; with Shift also, with Ctrl not any more; [ and ] size</source>
            <translation>Ziehen wählt, was überstrichen wird, bis Esc oder wieder C; mit Umschalt zusätzlich, mit Strg nicht mehr; [ und ] ändern die Größe</translation>
        </message>
        <message>
            <source>Draw the finger out of the surface, then arm again.</source>
            <translation>Finger aus der Oberfläche ziehen, dann Kräfte wieder einschalten.</translation>
        </message>
        <message>
            <source>Drawings</source>
            <translation>Zeichnungen</translation>
        </message>
        <message>
            <source>Draws the height layers a hundred times as high</source>
            <translation>Zeichnet die Höhenebenen hundertmal so hoch</translation>
        </message>
        <message>
            <source>Draws the height layers as they are</source>
            <translation>Zeichnet die Höhenebenen, wie sie sind</translation>
        </message>
        <message>
            <source>Draws the height layers ten times as high</source>
            <translation>Zeichnet die Höhenebenen zehnmal so hoch</translation>
        </message>
        <message>
            <source>Drift</source>
            <translation>Drift</translation>
        </message>
        <message>
            <source>Drop a picture on a surface of the model, or on the Layers panel for the selected surfaces.</source>
            <translation>Ein Bild auf einer Oberfläche des Modells ablegen oder, für die gewählten Oberflächen, auf dem Bereich Ebenen.</translation>
        </message>
        <message>
            <source>Drop to the ground</source>
            <translation>Auf den Boden setzen</translation>
        </message>
        <message>
            <source>Dry friction</source>
            <translation>Trockenreibung</translation>
        </message>
        <message>
            <source>Duplicate %1</source>
            <translation>%1 duplizieren</translation>
        </message>
        <message>
            <source>Duplicate layer %1</source>
            <translation>Ebene %1 duplizieren</translation>
        </message>
        <message>
            <source>Dynamic friction</source>
            <translation>Gleitreibung</translation>
        </message>
        <message>
            <source>E&amp;xport CSV...</source>
            <translation>CSV e&amp;xportieren...</translation>
        </message>
        <message>
            <source>E&amp;xport a report...</source>
            <translation>Be&amp;richt exportieren...</translation>
        </message>
        <message>
            <source>Each condition by itself</source>
            <translation>Jede Bedingung für sich</translation>
        </message>
        <message>
            <source>Each edit is compared with A at once</source>
            <translation>Jede Änderung wird sofort mit A verglichen</translation>
        </message>
        <message>
            <source>Each its own</source>
            <translation>Jedes seine</translation>
        </message>
        <message>
            <source>Edges that bend by more end a smooth region; normals farther apart are not similar.</source>
            <translation>Kanten, die stärker knicken, begrenzen ein glattes Gebiet; weiter auseinanderliegende Normalen sind nicht ähnlich.</translation>
        </message>
        <message>
            <source>Edges that bend by more than this stay sharp when normals are computed (section 3).</source>
            <translation>Kanten, die stärker knicken, bleiben scharf, wenn Normalen berechnet werden (Abschnitt 3).</translation>
        </message>
        <message>
            <source>Edit</source>
            <translation>Bearbeiten</translation>
        </message>
        <message>
            <source>Edit the scene, or compare after each edit.</source>
            <translation>Szene bearbeiten oder nach jeder Änderung vergleichen.</translation>
        </message>
        <message>
            <source>End it (E)</source>
            <translation>Beenden (E)</translation>
        </message>
        <message>
            <source>End the stroke</source>
            <translation>Strich beenden</translation>
        </message>
        <message>
            <source>End the study?</source>
            <translation>Möchten Sie die Studie beenden?</translation>
        </message>
        <message>
            <source>Ends after reversals</source>
            <translation>Ende nach Umkehrungen</translation>
        </message>
        <message>
            <source>Energy</source>
            <translation>Energie</translation>
        </message>
        <message>
            <source>Energy and motors</source>
            <translation>Energie und Motoren</translation>
        </message>
        <message>
            <source>Energy that the surface gave the hand beyond what it took. A real surface gives none: above 1 mJ the finger is damped until it is taken back. If that happens often, lower the stiffness or hold the handle more firmly.</source>
            <translation>Energie, die die Oberfläche der Hand über das hinaus gab, was sie nahm. Eine wirkliche Oberfläche gibt keine: Über 1 mJ wird der Finger gedämpft, bis sie zurückgenommen ist. Geschieht das oft, die Steifigkeit senken oder den Griff fester halten.</translation>
        </message>
        <message>
            <source>English</source>
            <translation>English</translation>
        </message>
        <message>
            <source>Error</source>
            <translation>Fehler</translation>
        </message>
        <message>
            <source>Every command by a few letters of it</source>
            <translation>Jeder Befehl über ein paar seiner Buchstaben</translation>
        </message>
        <message>
            <source>Every selected object turns and scales about its own middle</source>
            <translation>Jedes gewählte Objekt dreht und skaliert sich um seine eigene Mitte</translation>
        </message>
        <message>
            <source>Every step since the last jump gave what it gave then.</source>
            <translation>Jeder Schritt seit dem letzten Sprung ergab, was er damals ergab.</translation>
        </message>
        <message>
            <source>Every stroke adds; with Ctrl it takes away</source>
            <translation>Jeder Strich addiert; mit Strg zieht er ab</translation>
        </message>
        <message>
            <source>Every stroke evens out what is there</source>
            <translation>Jeder Strich ebnet ein, was da ist</translation>
        </message>
        <message>
            <source>Every stroke goes toward one value</source>
            <translation>Jeder Strich geht auf einen Wert zu</translation>
        </message>
        <message>
            <source>Every stroke takes away; with Ctrl it adds</source>
            <translation>Jeder Strich zieht ab; mit Strg addiert er</translation>
        </message>
        <message>
            <source>Every surface that feels like the active one</source>
            <translation>Jede Oberfläche, die sich anfühlt wie die aktive</translation>
        </message>
        <message>
            <source>Every surface that has the colour of the active one</source>
            <translation>Jede Oberfläche, die die Farbe der aktiven hat</translation>
        </message>
        <message>
            <source>Every surface that is visible</source>
            <translation>Jede Oberfläche, die sichtbar ist</translation>
        </message>
        <message>
            <source>Everything that moves goes to where it began</source>
            <translation>Alles, was sich bewegt, geht dorthin, wo es begann</translation>
        </message>
        <message>
            <source>Everything that was touched and felt in the last minute, to be played again bit for bit</source>
            <translation>Alles, was in der letzten Minute berührt und gefühlt wurde, um es Bit für Bit wieder abzuspielen</translation>
        </message>
        <message>
            <source>Export CSV...</source>
            <translation>CSV exportieren...</translation>
        </message>
        <message>
            <source>Export a bundle</source>
            <translation>Bündel exportieren</translation>
        </message>
        <message>
            <source>Export a report</source>
            <translation>Bericht exportieren</translation>
        </message>
        <message>
            <source>Export both touches</source>
            <translation>Beide Berührungen exportieren</translation>
        </message>
        <message>
            <source>Export the p&amp;lot...</source>
            <translation>Diagramm e&amp;xportieren...</translation>
        </message>
        <message>
            <source>Export the plot</source>
            <translation>Diagramm exportieren</translation>
        </message>
        <message>
            <source>Export the preset</source>
            <translation>Vorgabe exportieren</translation>
        </message>
        <message>
            <source>F&amp;elt normals</source>
            <translation>Gefühlte &amp;Normalen</translation>
        </message>
        <message>
            <source>F&amp;lat</source>
            <translation>&amp;Flach</translation>
        </message>
        <message>
            <source>F&amp;ront</source>
            <translation>Von &amp;vorn</translation>
        </message>
        <message>
            <source>Facets feel as the round surface that they stand for (section 3).</source>
            <translation>Facetten fühlen sich an wie die runde Oberfläche, für die sie stehen (Abschnitt 3).</translation>
        </message>
        <message>
            <source>Facing the same way</source>
            <translation>Gleiche Richtung</translation>
        </message>
        <message>
            <source>Falloff</source>
            <translation>Auslauf</translation>
        </message>
        <message>
            <source>Fault: %1</source>
            <translation>Störung: %1</translation>
        </message>
        <message>
            <source>Feel again (R)</source>
            <translation>Noch einmal fühlen (R)</translation>
        </message>
        <message>
            <source>Feel all layers again (S)</source>
            <translation>Wieder alle Ebenen fühlen (S)</translation>
        </message>
        <message>
            <source>Feel the scene again</source>
            <translation>Wieder die Szene fühlen</translation>
        </message>
        <message>
            <source>Feel the selected layer alone; the scene keeps which layers are on</source>
            <translation>Nur die gewählte Ebene fühlen; die Szene behält, welche Ebenen an sind</translation>
        </message>
        <message>
            <source>Feel this layer alone (S)</source>
            <translation>Nur diese Ebene fühlen (S)</translation>
        </message>
        <message>
            <source>Felt from</source>
            <translation>Fühlbare Seite</translation>
        </message>
        <message>
            <source>Felt from the side that sees the corners clockwise alone.</source>
            <translation>Nur von der Seite gefühlt, die die Ecken im Uhrzeigersinn sieht.</translation>
        </message>
        <message>
            <source>Felt from the side that sees the corners counter-clockwise alone.</source>
            <translation>Nur von der Seite gefühlt, die die Ecken gegen den Uhrzeigersinn sieht.</translation>
        </message>
        <message>
            <source>Felt from whichever side it is met.</source>
            <translation>Gefühlt von jeder Seite, von der man ihr begegnet.</translation>
        </message>
        <message>
            <source>Felt from: %1</source>
            <translation>Fühlbare Seite: %1</translation>
        </message>
        <message>
            <source>Felt sides of %1</source>
            <translation>Fühlbare Seiten von %1</translation>
        </message>
        <message>
            <source>Fewer than two surfaces are selected.</source>
            <translation>Weniger als zwei Oberflächen sind gewählt.</translation>
        </message>
        <message>
            <source>Figure</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>File</source>
            <translation>Datei</translation>
        </message>
        <message>
            <source>Fill</source>
            <translation>Füllung</translation>
        </message>
        <message>
            <source>Finding the neighbours of every triangle</source>
            <translation>Nachbarn jedes Dreiecks werden gesucht</translation>
        </message>
        <message>
            <source>Finds what has all these words, on every page (%1)</source>
            <translation>Findet, was alle diese Wörter hat, auf jeder Seite (%1)</translation>
        </message>
        <message>
            <source>Finger an&amp;d forces</source>
            <translation>&amp;Finger und Kräfte</translation>
        </message>
        <message>
            <source>First difference</source>
            <translation>Erster Unterschied</translation>
        </message>
        <message>
            <source>Fit the &amp;workspace to the model</source>
            <translation>Arbeitsraum an das &amp;Modell anpassen</translation>
        </message>
        <message>
            <source>Fit to the model</source>
            <translation>An Modell anpassen</translation>
        </message>
        <message>
            <source>Fix</source>
            <translation>Beheben</translation>
        </message>
        <message>
            <source>Fix %1</source>
            <translation>%1 beheben</translation>
        </message>
        <message>
            <source>Fixed to</source>
            <translation>Fest an</translation>
        </message>
        <message>
            <source>Flat normals of %1</source>
            <translation>Flache Normalen von %1</translation>
        </message>
        <message>
            <source>Fold the &amp;lists</source>
            <translation>&amp;Listen einklappen</translation>
        </message>
        <message>
            <source>Fold the &amp;plots</source>
            <translation>&amp;Diagramme einklappen</translation>
        </message>
        <message>
            <source>Fold these panels, so that the view has their room</source>
            <translation>Diese Bereiche einklappen, damit die Ansicht ihren Platz hat</translation>
        </message>
        <message>
            <source>Foldin&amp;g</source>
            <translation>Einkla&amp;ppen</translation>
        </message>
        <message>
            <source>For the %1. Your copy is checked, and kept where the driver finds it</source>
            <translation>Für: %1. Ihre Kopie wird geprüft und dort abgelegt, wo der Treiber sie findet</translation>
        </message>
        <message>
            <source>Force</source>
            <translation>Kraft</translation>
        </message>
        <message>
            <source>Force %1 N of %2 N</source>
            <translation>Kraft %1 N von %2 N</translation>
        </message>
        <message>
            <source>Force against each metre a second.</source>
            <translation>Kraft gegen jeden Meter je Sekunde.</translation>
        </message>
        <message>
            <source>Force against the speed of the finger into the surface. It never pulls the finger inward.</source>
            <translation>Kraft gegen die Geschwindigkeit des Fingers in die Oberfläche hinein. Sie zieht den Finger nie nach innen.</translation>
        </message>
        <message>
            <source>Force for each metre away from where the spring rests.</source>
            <translation>Kraft für jeden Meter weg von der Ruhelage der Feder.</translation>
        </message>
        <message>
            <source>Force of the stroke in both states</source>
            <translation>Kraft des Strichs in beiden Zuständen</translation>
        </message>
        <message>
            <source>Force of the virtual spring for each metre between proxy and finger (equation 24). Values above the device's ceiling are clamped to it.</source>
            <translation>Kraft der virtuellen Feder für jeden Meter zwischen Proxy und Finger (Gleichung 24). Werte über der Steifigkeitsgrenze des Geräts werden auf sie begrenzt.</translation>
        </message>
        <message>
            <source>Force only while a button of the device is held. Of the simulated hand: while the mouse holds the finger</source>
            <translation>Kraft nur, solange eine Taste des Geräts gehalten wird. Bei der simulierten Hand: solange die Maus den Finger hält</translation>
        </message>
        <message>
            <source>Force over time</source>
            <translation>Kraft über der Zeit</translation>
        </message>
        <message>
            <source>Force scale</source>
            <translation>Kraftmaßstab</translation>
        </message>
        <message>
            <source>Force shading</source>
            <translation>Kraft-Shading</translation>
        </message>
        <message>
            <source>Force shading of %1</source>
            <translation>Kraft-Shading von %1</translation>
        </message>
        <message>
            <source>Force shading with computed normals: edges below the crease angle feel round</source>
            <translation>Kraft-Shading mit berechneten Normalen: Kanten unter dem Knickwinkel fühlen sich rund an</translation>
        </message>
        <message>
            <source>Force shading with the normals that the file brought along</source>
            <translation>Kraft-Shading mit den Normalen, die die Datei mitbrachte</translation>
        </message>
        <message>
            <source>Force, health and comparison to their tabs, so that the view has their room</source>
            <translation>Kraft, Zustand und Vergleich auf ihre Reiter, damit die Ansicht ihren Platz hat</translation>
        </message>
        <message>
            <source>Forces</source>
            <translation>Kräfte</translation>
        </message>
        <message>
            <source>Forces come %1 ticks after their reading, and the profile says %2: with it surfaces may be too stiff and tremble.</source>
            <translation>Kräfte kommen %1 Takte nach ihrem Messwert, und das Profil sagt %2: Damit können Oberflächen zu steif sein und zittern.</translation>
        </message>
        <message>
            <source>Forces off</source>
            <translation>Kräfte aus</translation>
        </message>
        <message>
            <source>Forces off at once. Also: hold Esc for half a second.</source>
            <translation>Kräfte sofort aus. Auch: Esc eine halbe Sekunde halten.</translation>
        </message>
        <message>
            <source>Forces off at once; also hold Esc for half a second</source>
            <translation>Kräfte sofort aus; auch Esc eine halbe Sekunde halten</translation>
        </message>
        <message>
            <source>Forces off while something is asked</source>
            <translation>Kräfte aus, während etwas gefragt wird</translation>
        </message>
        <message>
            <source>Forces off, and out</source>
            <translation>Kräfte aus und beenden</translation>
        </message>
        <message>
            <source>Forces on (F)</source>
            <translation>Kräfte an (F)</translation>
        </message>
        <message>
            <source>Forget them</source>
            <translation>Liste leeren</translation>
        </message>
        <message>
            <source>Four views, from above, your own, from the front and from the right; again for one view</source>
            <translation>Vier Ansichten, von oben, die eigene, von vorn und von rechts; noch einmal für eine Ansicht</translation>
        </message>
        <message>
            <source>Frees a proxy that is on the wrong side of a surface</source>
            <translation>Befreit einen Proxy, der auf der falschen Seite einer Oberfläche ist</translation>
        </message>
        <message>
            <source>Friction</source>
            <translation>Reibung</translation>
        </message>
        <message>
            <source>Friction &amp;cone</source>
            <translation>&amp;Reibungskegel</translation>
        </message>
        <message>
            <source>Friction ratio</source>
            <translation>Reibungsverhältnis</translation>
        </message>
        <message>
            <source>From a file...</source>
            <translation>Aus einer Datei...</translation>
        </message>
        <message>
            <source>From the &amp;file</source>
            <translation>Aus der &amp;Datei</translation>
        </message>
        <message>
            <source>From the sam&amp;ples</source>
            <translation>Aus den B&amp;eispielen</translation>
        </message>
        <message>
            <source>Front</source>
            <translation>Vorn</translation>
        </message>
        <message>
            <source>Frozen, without a finger</source>
            <translation>Eingefroren, ohne Finger</translation>
        </message>
        <message>
            <source>G</source>
            <translation>G</translation>
        </message>
        <message>
            <source>G, R, S, move tool</source>
            <translation>G, R, S, Werkzeug Verschieben</translation>
        </message>
        <message>
            <source>Gamepad</source>
            <translation>Gamepad</translation>
        </message>
        <message>
            <source>Gamepads are looked for while this is on</source>
            <translation>Gamepads werden gesucht, solange dies an ist</translation>
        </message>
        <message>
            <source>Geometry of %1</source>
            <translation>Geometrie von %1</translation>
        </message>
        <message>
            <source>Give the device back; the mouse leads a simulated hand</source>
            <translation>Das Gerät zurückgeben; die Maus führt eine simulierte Hand</translation>
        </message>
        <message>
            <source>Give the device of the chosen hand back. The forces of all hands are off then</source>
            <translation>Das Gerät der gewählten Hand zurückgeben. Die Kräfte aller Hände sind dann aus</translation>
        </message>
        <message>
            <source>Give the keys to the next panel</source>
            <translation>Die Tastatur dem nächsten Bereich geben</translation>
        </message>
        <message>
            <source>Give the keys to the panel before</source>
            <translation>Die Tastatur dem vorigen Bereich geben</translation>
        </message>
        <message>
            <source>Give this device back. The forces of all hands are off then</source>
            <translation>Dieses Gerät zurückgeben. Die Kräfte aller Hände sind dann aus</translation>
        </message>
        <message>
            <source>Give up</source>
            <translation>Aufgeben</translation>
        </message>
        <message>
            <source>Given</source>
            <translation>Abgegeben</translation>
        </message>
        <message>
            <source>Giving up</source>
            <translation>Wird aufgegeben</translation>
        </message>
        <message>
            <source>Glass and stone</source>
            <translation>Glas und Stein</translation>
        </message>
        <message>
            <source>Glass on glass</source>
            <translation>Glas auf Glas</translation>
        </message>
        <message>
            <source>Glass on nickel</source>
            <translation>Glas auf Nickel</translation>
        </message>
        <message>
            <source>Glaze and cork, and facets that feel round</source>
            <translation>Glasur und Kork, und Facetten, die sich rund anfühlen</translation>
        </message>
        <message>
            <source>Go away from the model</source>
            <translation>Vom Modell weggehen</translation>
        </message>
        <message>
            <source>Go on (Space)</source>
            <translation>Weiter (Leertaste)</translation>
        </message>
        <message>
            <source>Go on without it</source>
            <translation>Ohne sie weitermachen</translation>
        </message>
        <message>
            <source>Goes farther</source>
            <translation>Geht weiter weg</translation>
        </message>
        <message>
            <source>Grain, stitches and a worn place: textures laid over each other</source>
            <translation>Narbung, Nähte und eine abgegriffene Stelle: Texturen übereinander</translation>
        </message>
        <message>
            <source>Gravity</source>
            <translation>Schwerkraft</translation>
        </message>
        <message>
            <source>Gravity x</source>
            <translation>Schwerkraft x</translation>
        </message>
        <message>
            <source>Gravity y</source>
            <translation>Schwerkraft y</translation>
        </message>
        <message>
            <source>Gravity z</source>
            <translation>Schwerkraft z</translation>
        </message>
        <message>
            <source>Grooves</source>
            <translation>Rillen</translation>
        </message>
        <message>
            <source>Group %1</source>
            <translation>%1 gruppieren</translation>
        </message>
        <message>
            <source>Guess</source>
            <translation>Schätzen</translation>
        </message>
        <message>
            <source>Guide</source>
            <translation>Handbuch</translation>
        </message>
        <message>
            <source>HOST:PORT, as in 127.0.0.1:51270</source>
            <translation>HOST:PORT, etwa 127.0.0.1:51270</translation>
        </message>
        <message>
            <source>Handle</source>
            <translation>Griff</translation>
        </message>
        <message>
            <source>Handle at %1, %2, %3 mm in a workspace of %4 mm about the centre</source>
            <translation>Griff bei %1, %2, %3 mm in einem Arbeitsraum von %4 mm um die Mitte</translation>
        </message>
        <message>
            <source>Handles along</source>
            <translation>Anfasser entlang</translation>
        </message>
        <message>
            <source>Handles in the view that move, turn and scale the selected layer's mapping (G with the select tool)</source>
            <translation>Anfasser in der Ansicht, die die Abbildung der gewählten Ebene verschieben, drehen und skalieren (G mit dem Werkzeug Auswählen)</translation>
        </message>
        <message>
            <source>Hang the mass on the handle by a thread, and let it come to rest.</source>
            <translation>Die Masse an einem Faden an den Griff hängen und zur Ruhe kommen lassen.</translation>
        </message>
        <message>
            <source>Haptic devices</source>
            <translation>Haptische Geräte</translation>
        </message>
        <message>
            <source>Haptic server %1, %2</source>
            <translation>Haptischer Server %1, %2</translation>
        </message>
        <message>
            <source>Haptic server %1, %2 clients, %3</source>
            <translation>Haptischer Server %1, %2 Clients, %3</translation>
        </message>
        <message>
            <source>Hard as rubber</source>
            <translation>Hart wie Gummi</translation>
        </message>
        <message>
            <source>Hard as wood</source>
            <translation>Hart wie Holz</translation>
        </message>
        <message>
            <source>Health</source>
            <translation>Zustand</translation>
        </message>
        <message>
            <source>Health of the loops</source>
            <translation>Zustand der Schleifen</translation>
        </message>
        <message>
            <source>Heat of the motors; 100 % is what they bear for ever. From 70 % on the limit falls from the peak force to the continuous one. Press less, or let them cool.</source>
            <translation>Wärme der Motoren; 100 % ist, was sie dauerhaft aushalten. Ab 70 % sinkt die Grenze von der Spitzenkraft auf die Dauerkraft. Weniger drücken oder sie abkühlen lassen.</translation>
        </message>
        <message>
            <source>Height</source>
            <translation>Höhe</translation>
        </message>
        <message>
            <source>Height layers tilt the light as they tilt what is felt; the shape stays as it is</source>
            <translation>Höhenebenen neigen das Licht, wie sie neigen, was gefühlt wird; die Form bleibt, wie sie ist</translation>
        </message>
        <message>
            <source>Height of texture</source>
            <translation>Höhe der Textur</translation>
        </message>
        <message>
            <source>Height of the pattern's highest places above its lowest; negative turns bumps into dents. The surface is tilted by it, never lifted (section 4.3).</source>
            <translation>Höhe der höchsten Stellen des Musters über den tiefsten; negativ macht aus Erhebungen Dellen. Die Oberfläche wird davon geneigt, nie gehoben (Abschnitt 4.3).</translation>
        </message>
        <message>
            <source>Held buttons: %1</source>
            <translation>Gehaltene Tasten: %1</translation>
        </message>
        <message numerus="yes">
            <source>Held by %n joint(s) of another kind, which stay as they are in the file.</source>
            <translation>
                <numerusform>Gehalten von %n Gelenk anderer Art, das in der Datei bleibt, wie es ist.</numerusform>
                <numerusform>Gehalten von %n Gelenken anderer Art, die in der Datei bleiben, wie sie sind.</numerusform>
            </translation>
        </message>
        <message>
            <source>Help</source>
            <translation>Hilfe</translation>
        </message>
        <message>
            <source>Hidden</source>
            <translation>Verborgen</translation>
        </message>
        <message>
            <source>Hide %1</source>
            <translation>%1 ausblenden</translation>
        </message>
        <message>
            <source>Hide al&amp;l panels</source>
            <translation>A&amp;lle Bereiche ausblenden</translation>
        </message>
        <message>
            <source>Hide everything but the selected surfaces</source>
            <translation>Alles außer den gewählten Oberflächen ausblenden</translation>
        </message>
        <message>
            <source>Hide: it is neither seen nor felt (H)</source>
            <translation>Ausblenden: weder zu sehen noch zu fühlen (H)</translation>
        </message>
        <message>
            <source>Hinge</source>
            <translation>Scharnier</translation>
        </message>
        <message>
            <source>History</source>
            <translation>Verlauf</translation>
        </message>
        <message>
            <source>Hold Esc for half a second</source>
            <translation>Esc eine halbe Sekunde halten</translation>
        </message>
        <message>
            <source>Hold the &amp;button to feel</source>
            <translation>Zum Fühlen Taste &amp;halten</translation>
        </message>
        <message>
            <source>Hold the button to feel; if you do, let it go once first.</source>
            <translation>Zum Fühlen die Taste halten; wird sie schon gehalten, einmal loslassen.</translation>
        </message>
        <message>
            <source>Hold the chart still</source>
            <translation>Das Diagramm anhalten</translation>
        </message>
        <message>
            <source>Hold the handle.</source>
            <translation>Griff halten.</translation>
        </message>
        <message>
            <source>Hold the sails against the wind</source>
            <translation>Die Flügel gegen den Wind festhalten</translation>
        </message>
        <message>
            <source>Honey</source>
            <translation>Honig</translation>
        </message>
        <message>
            <source>How a hand reaches beyond the device's workspace: not at all, by pulling beyond a border that is felt, or by a drift too slow to be noticed. It belongs to the scene and is for every hand.</source>
            <translation>Wie eine Hand über den Arbeitsraum des Geräts hinausreicht: gar nicht, indem sie über eine Grenze hinaus zieht, die zu fühlen ist, oder durch eine Drift, die zu langsam ist, um bemerkt zu werden. Es gehört zur Szene und gilt für jede Hand.</translation>
        </message>
        <message>
            <source>How far a drag turns the camera: 1 is half a turn for the shorter side of the view.</source>
            <translation>Wie weit ein Ziehen die Kamera dreht: 1 ist eine halbe Drehung für die kürzere Seite der Ansicht.</translation>
        </message>
        <message>
            <source>How far from its middle the brush paints, measured straight through space.</source>
            <translation>Wie weit von seiner Mitte der Pinsel malt, gerade durch den Raum gemessen.</translation>
        </message>
        <message>
            <source>How far it slides back; a metre: without stop.</source>
            <translation>Wie weit er zurückgleitet; ein Meter: ohne Anschlag.</translation>
        </message>
        <message>
            <source>How far it slides; a metre: without stop.</source>
            <translation>Wie weit er gleitet; ein Meter: ohne Anschlag.</translation>
        </message>
        <message>
            <source>How far it turns back; a whole turn: without stop.</source>
            <translation>Wie weit er sich zurückdreht; eine ganze Drehung: ohne Anschlag.</translation>
        </message>
        <message>
            <source>How far it turns; a whole turn: without stop.</source>
            <translation>Wie weit er sich dreht; eine ganze Drehung: ohne Anschlag.</translation>
        </message>
        <message>
            <source>How far the handle has gone</source>
            <translation>Wie weit der Griff bewegt wurde</translation>
        </message>
        <message>
            <source>How far the pattern is moved across its rows.</source>
            <translation>Wie weit das Muster quer zu seinen Reihen verschoben ist.</translation>
        </message>
        <message>
            <source>How far the pattern is moved along its rows.</source>
            <translation>Wie weit das Muster entlang seiner Reihen verschoben ist.</translation>
        </message>
        <message>
            <source>How far the pattern is turned on the surface, counter-clockwise.</source>
            <translation>Wie weit das Muster auf der Oberfläche gegen den Uhrzeigersinn gedreht ist.</translation>
        </message>
        <message>
            <source>How far the servo's periods were from their length in the last seconds, on logarithmic axes. Bars far to the right lower the stiffness ceiling. Real-time priority moves them to the left.</source>
            <translation>Wie weit die Servoperioden in den letzten Sekunden von ihrer Länge abwichen, auf logarithmischen Achsen. Balken weit rechts senken die Steifigkeitsgrenze. Echtzeitpriorität schiebt sie nach links.</translation>
        </message>
        <message>
            <source>How hard it is to move. At first that of its volume in water.</source>
            <translation>Wie schwer er zu bewegen ist. Zunächst die Masse seines Volumens in Wasser.</translation>
        </message>
        <message>
            <source>How much larger than when it was selected; textures and masses stay.</source>
            <translation>Wie viel größer als beim Auswählen; Texturen und Massen bleiben.</translation>
        </message>
        <message>
            <source>How much nearer a notch of the wheel comes: 1 is 13 %.</source>
            <translation>Wie viel näher eine Raste des Mausrads kommt: 1 ist 13 %.</translation>
        </message>
        <message>
            <source>How much of a repeat is raised, between grooves or as a dot.</source>
            <translation>Wie viel einer Wiederholung erhaben ist, zwischen Rillen oder als Noppe.</translation>
        </message>
        <message>
            <source>How much of the layer counts.</source>
            <translation>Wie sehr die Ebene zählt.</translation>
        </message>
        <message>
            <source>How much of the scene's gravity it feels; 0: it floats.</source>
            <translation>Wie viel von der Schwerkraft der Szene auf ihn wirkt; 0: Er schwebt.</translation>
        </message>
        <message>
            <source>How much of the step is done</source>
            <translation>Wie viel vom Schritt erledigt ist</translation>
        </message>
        <message>
            <source>How much of this part is measured</source>
            <translation>Wie viel von diesem Teil gemessen ist</translation>
        </message>
        <message>
            <source>How much one stroke changes in the middle of the brush, however often it crosses itself.</source>
            <translation>Wie viel ein Strich in der Mitte des Pinsels ändert, wie oft er sich auch kreuzt.</translation>
        </message>
        <message>
            <source>How the flat pattern comes onto the surface</source>
            <translation>Wie das flache Muster auf die Oberfläche kommt</translation>
        </message>
        <message>
            <source>How the layer joins what lies below it</source>
            <translation>Wie sich die Ebene mit dem verbindet, was unter ihr liegt</translation>
        </message>
        <message>
            <source>How to do things, task by task</source>
            <translation>Wie man etwas macht, Aufgabe für Aufgabe</translation>
        </message>
        <message>
            <source>How you hold it</source>
            <translation>Haltung</translation>
        </message>
        <message>
            <source>How you hold the handle</source>
            <translation>Wie Sie den Griff halten</translation>
        </message>
        <message>
            <source>I take the risk</source>
            <translation>Risiko übernehmen</translation>
        </message>
        <message>
            <source>Ice and snow</source>
            <translation>Eis und Schnee</translation>
        </message>
        <message>
            <source>Ice on ice</source>
            <translation>Eis auf Eis</translation>
        </message>
        <message>
            <source>Image</source>
            <translation>Bild</translation>
        </message>
        <message>
            <source>Import presets</source>
            <translation>Vorgaben importieren</translation>
        </message>
        <message>
            <source>In &amp;light and shade</source>
            <translation>Mit &amp;Licht und Schatten</translation>
        </message>
        <message>
            <source>In a moment, along its way</source>
            <translation>In kurzer Fahrt</translation>
        </message>
        <message>
            <source>In the view</source>
            <translation>In der Ansicht</translation>
        </message>
        <message>
            <source>In which unit lengths are shown and typed. Plots, devices and files keep theirs; other units can always be typed with their names, as in "0.2 in".</source>
            <translation>In welcher Einheit Längen gezeigt und eingegeben werden. Diagramme, Geräte und Dateien behalten ihre; andere Einheiten können immer mit ihrem Namen eingegeben werden, wie in "0.2 in".</translation>
        </message>
        <message>
            <source>In which unit stiffnesses are shown and typed.</source>
            <translation>In welcher Einheit Steifigkeiten gezeigt und eingegeben werden.</translation>
        </message>
        <message>
            <source>In&amp;vert</source>
            <translation>&amp;Umkehren</translation>
        </message>
        <message>
            <source>Inches</source>
            <translation>Zoll</translation>
        </message>
        <message>
            <source>Instructions for the participant</source>
            <translation>Anweisungen für die teilnehmende Person</translation>
        </message>
        <message>
            <source>Is&amp;ometric</source>
            <translation>Isome&amp;trisch</translation>
        </message>
        <message>
            <source>It comes back softly by itself.</source>
            <translation>Sie kommt von selbst sanft zurück.</translation>
        </message>
        <message>
            <source>It comes back softly when the loop answers; a lighter scene helps.</source>
            <translation>Sie kommt sanft zurück, wenn die Schleife antwortet; eine leichtere Szene hilft.</translation>
        </message>
        <message>
            <source>It falls, lies, and is pushed.</source>
            <translation>Fällt, liegt und wird geschoben.</translation>
        </message>
        <message>
            <source>It goes on by itself.</source>
            <translation>Es geht von selbst weiter.</translation>
        </message>
        <message>
            <source>It has no effect as things are.</source>
            <translation>So, wie die Dinge liegen, hat es keine Wirkung.</translation>
        </message>
        <message>
            <source>It is being measured.</source>
            <translation>Es wird gemessen.</translation>
        </message>
        <message>
            <source>It is no longer there</source>
            <translation>Sie ist nicht mehr da</translation>
        </message>
        <message>
            <source>It is ready, and becomes a hand when the forces are off.</source>
            <translation>Es ist bereit und wird eine Hand, sobald die Kräfte aus sind.</translation>
        </message>
        <message>
            <source>It lies where the mesh's texture coordinates put it; the other mappings have a frame that can be moved in the view.</source>
            <translation>Sie liegt dort, wohin die Texturkoordinaten des Netzes sie legen; die anderen Abbildungen haben einen Rahmen, der in der Ansicht bewegt werden kann.</translation>
        </message>
        <message>
            <source>It reads %1 times a second and not %2: plug it into a socket of the computer itself, and look at tactum devices --latency 10.</source>
            <translation>Es misst %1-mal je Sekunde und nicht %2-mal: an eine Buchse des Rechners selbst anschließen und tactum devices --latency 10 ansehen.</translation>
        </message>
        <message>
            <source>It rests at its beginning and every so far from it; 0: it has no detents.</source>
            <translation>Es rastet am Anfang und in diesem Abstand davon; 0: ohne Rasten.</translation>
        </message>
        <message>
            <source>It rides on a curve.</source>
            <translation>Fährt auf einer Kurve.</translation>
        </message>
        <message>
            <source>It rises to all of it in 0.6 s, slower under load.</source>
            <translation>Sie steigt in 0.6 s auf den vollen Wert, unter Last langsamer.</translation>
        </message>
        <message>
            <source>It rolls in every direction.</source>
            <translation>Rollt in jede Richtung.</translation>
        </message>
        <message>
            <source>It slides along one axis.</source>
            <translation>Gleitet entlang einer Achse.</translation>
        </message>
        <message>
            <source>It stands on the ground already.</source>
            <translation>Es steht schon auf dem Boden.</translation>
        </message>
        <message>
            <source>It stands still.</source>
            <translation>Steht still.</translation>
        </message>
        <message>
            <source>It tells of more buttons than the %1 that its profile says.</source>
            <translation>Es meldet mehr Tasten als die %1, die sein Profil nennt.</translation>
        </message>
        <message>
            <source>It turns about one axis.</source>
            <translation>Dreht sich um eine Achse.</translation>
        </message>
        <message>
            <source>It waits until it would be small for 20 ms.</source>
            <translation>Sie wartet, bis sie 20 ms lang klein wäre.</translation>
        </message>
        <message>
            <source>It was taken away instead.</source>
            <translation>Sie wurde stattdessen weggenommen.</translation>
        </message>
        <message>
            <source>Its conditions, procedure and questions</source>
            <translation>Ihre Bedingungen, ihr Ablauf und ihre Fragen</translation>
        </message>
        <message>
            <source>Its numbers to the clipboard</source>
            <translation>Seine Zahlen in die Zwischenablage</translation>
        </message>
        <message>
            <source>Joint</source>
            <translation>Gelenk</translation>
        </message>
        <message>
            <source>Joint %1</source>
            <translation>Gelenk %1</translation>
        </message>
        <message>
            <source>Joint %1: %2</source>
            <translation>Gelenk %1: %2</translation>
        </message>
        <message>
            <source>Joint angle</source>
            <translation>Gelenkwinkel</translation>
        </message>
        <message>
            <source>Joint cartilage</source>
            <translation>Gelenkknorpel</translation>
        </message>
        <message>
            <source>Joint force</source>
            <translation>Gelenkkraft</translation>
        </message>
        <message>
            <source>Joint torque</source>
            <translation>Gelenkmoment</translation>
        </message>
        <message>
            <source>Joint way</source>
            <translation>Gelenkweg</translation>
        </message>
        <message>
            <source>Kee&amp;p as a set...</source>
            <translation>Als Satz be&amp;wahren...</translation>
        </message>
        <message>
            <source>Keep how the active surface feels in the library, under a name</source>
            <translation>Unter einem Namen in der Bibliothek behalten, wie sich die aktive Oberfläche anfühlt</translation>
        </message>
        <message>
            <source>Keep the selection</source>
            <translation>Die Auswahl behalten</translation>
        </message>
        <message>
            <source>Keep the set %1</source>
            <translation>Den Satz %1 behalten</translation>
        </message>
        <message>
            <source>Keep the view %1</source>
            <translation>Ansicht %1 behalten</translation>
        </message>
        <message>
            <source>Keep this state</source>
            <translation>Zustand festhalten</translation>
        </message>
        <message>
            <source>Keep this state...</source>
            <translation>Zustand festhalten...</translation>
        </message>
        <message>
            <source>Keep this view</source>
            <translation>Diese Ansicht behalten</translation>
        </message>
        <message>
            <source>Keep your hands off: it holds itself in the middle and shakes.</source>
            <translation>Hände weg: Es hält sich selbst in der Mitte und rüttelt.</translation>
        </message>
        <message>
            <source>Keep your hands off: it swings slowly, without the mass.</source>
            <translation>Hände weg: Es schwingt langsam, ohne die Masse.</translation>
        </message>
        <message>
            <source>Kept as a condition of the study: %1</source>
            <translation>Als Bedingung der Studie festgehalten: %1</translation>
        </message>
        <message>
            <source>Kept for a crash after</source>
            <translation>Für einen Absturz gesichert nach</translation>
        </message>
        <message>
            <source>Keyboard and mouse</source>
            <translation>Tastatur und Maus</translation>
        </message>
        <message>
            <source>Keys on springs, with preload and stops</source>
            <translation>Tasten auf Federn, mit Vorspannung und Anschlägen</translation>
        </message>
        <message>
            <source>Kind</source>
            <translation>Art</translation>
        </message>
        <message>
            <source>Language</source>
            <translation>Sprache</translation>
        </message>
        <message>
            <source>Largest difference</source>
            <translation>Größter Unterschied</translation>
        </message>
        <message>
            <source>Largest force</source>
            <translation>Größte Kraft</translation>
        </message>
        <message>
            <source>Largest ratio of tangential to normal force at which a resting contact holds (section 4.1).</source>
            <translation>Größtes Verhältnis von Tangential- zu Normalkraft, bei dem ein ruhender Kontakt hält (Abschnitt 4.1).</translation>
        </message>
        <message>
            <source>Last events</source>
            <translation>Letzte Ereignisse</translation>
        </message>
        <message>
            <source>Late ticks: %1</source>
            <translation>Verspätete Takte: %1</translation>
        </message>
        <message>
            <source>Lay a ruler that points %1, and hold the handle at its beginning, near the middle of the workspace.</source>
            <translation>Ein Lineal so legen, dass es %1 zeigt, und den Griff an seinen Anfang halten, nahe der Mitte des Arbeitsraums.</translation>
        </message>
        <message>
            <source>Layer</source>
            <translation>Ebene</translation>
        </message>
        <message>
            <source>Layer %1</source>
            <translation>Ebene %1</translation>
        </message>
        <message>
            <source>Layer %1 on %2</source>
            <translation>Ebene %1 auf %2</translation>
        </message>
        <message>
            <source>Layer %1, mask: %2</source>
            <translation>Ebene %1, Maske: %2</translation>
        </message>
        <message>
            <source>Layer %1: %2</source>
            <translation>Ebene %1: %2</translation>
        </message>
        <message>
            <source>Layers</source>
            <translation>Ebenen</translation>
        </message>
        <message>
            <source>Layers of haptic texture on a surface: what they change by how much, in which order. Click a surface in the view (Q) or in the outliner, or drop a picture on the model.</source>
            <translation>Ebenen haptischer Textur auf einer Oberfläche: was sie wie stark und in welcher Reihenfolge ändern. Eine Oberfläche in der Ansicht (Q) oder in der Szenenliste anklicken oder ein Bild auf dem Modell ablegen.</translation>
        </message>
        <message>
            <source>Layers of noise, each twice as fine and half as high as the one before.</source>
            <translation>Schichten von Rauschen, jede doppelt so fein und halb so hoch wie die vorige.</translation>
        </message>
        <message>
            <source>Layers of texture</source>
            <translation>Texturebenen</translation>
        </message>
        <message>
            <source>Layers to add</source>
            <translation>Ebenen zum Hinzufügen</translation>
        </message>
        <message>
            <source>Layers, topmost first</source>
            <translation>Ebenen, oberste zuerst</translation>
        </message>
        <message>
            <source>Lead the handle 40 mm %1 along the ruler, and hold it there.</source>
            <translation>Den Griff am Lineal 40 mm %1 führen und dort halten.</translation>
        </message>
        <message>
            <source>Lead the handle to the middle of the workspace and let go. It will twitch a little each way.</source>
            <translation>Den Griff in die Mitte des Arbeitsraums führen und loslassen. Er wird in jede Richtung ein wenig zucken.</translation>
        </message>
        <message>
            <source>Leather and cloth</source>
            <translation>Leder und Stoff</translation>
        </message>
        <message>
            <source>Leather on oak</source>
            <translation>Leder auf Eiche</translation>
        </message>
        <message>
            <source>Leave the axes as they were</source>
            <translation>Achsen lassen, wie sie waren</translation>
        </message>
        <message>
            <source>Left</source>
            <translation>Links</translation>
        </message>
        <message>
            <source>Left out:</source>
            <translation>Ausgelassen:</translation>
        </message>
        <message>
            <source>Lengths</source>
            <translation>Längen</translation>
        </message>
        <message>
            <source>Let go of the handle, so that it rests by itself.</source>
            <translation>Den Griff loslassen, sodass er von selbst ruht.</translation>
        </message>
        <message>
            <source>Let me use devices</source>
            <translation>Geräte erlauben</translation>
        </message>
        <message>
            <source>Let the button go to feel again.</source>
            <translation>Taste loslassen, um wieder zu fühlen.</translation>
        </message>
        <message>
            <source>Let the device push. Hold the handle: the force comes softly.</source>
            <translation>Das Gerät drücken lassen. Den Griff halten: Die Kraft kommt sanft.</translation>
        </message>
        <message>
            <source>Let the device push. It starts without force and follows</source>
            <translation>Das Gerät drücken lassen. Es beginnt ohne Kraft und folgt</translation>
        </message>
        <message>
            <source>Let them</source>
            <translation>Erlauben</translation>
        </message>
        <message>
            <source>Let time go on for all that moves: along keys, by its weight, by the hand</source>
            <translation>Zeit laufen lassen für alles, was sich bewegt: nach Keyframes, durch sein Gewicht, durch die Hand</translation>
        </message>
        <message>
            <source>Lift off until you touch nothing.</source>
            <translation>Bitte heben Sie ab, bis Sie nichts mehr berühren.</translation>
        </message>
        <message>
            <source>Light</source>
            <translation>Hell</translation>
        </message>
        <message>
            <source>Light figures on dark grey</source>
            <translation>Helle Figuren auf Dunkelgrau</translation>
        </message>
        <message>
            <source>Lighten (maximum)</source>
            <translation>Aufhellen (Maximum)</translation>
        </message>
        <message>
            <source>Lightly, with the fingers</source>
            <translation>Locker, mit den Fingern</translation>
        </message>
        <message>
            <source>Like the &amp;system</source>
            <translation>Wie das &amp;System</translation>
        </message>
        <message>
            <source>Like the system</source>
            <translation>Wie das System</translation>
        </message>
        <message>
            <source>Limited to the device's %1 N</source>
            <translation>Auf %1 N des Geräts begrenzt</translation>
        </message>
        <message>
            <source>Limits</source>
            <translation>Grenzen</translation>
        </message>
        <message>
            <source>Line for a terminal</source>
            <translation>Zeile für ein Terminal</translation>
        </message>
        <message>
            <source>Link</source>
            <translation>Link</translation>
        </message>
        <message>
            <source>Liquid</source>
            <translation>Flüssigkeit</translation>
        </message>
        <message>
            <source>Listening to the device at rest.</source>
            <translation>Das Gerät wird in Ruhe abgehört.</translation>
        </message>
        <message>
            <source>Live</source>
            <translation>Live</translation>
        </message>
        <message>
            <source>Live again. The forces are off: Device &gt; Forces on.</source>
            <translation>Wieder Live. Die Kräfte sind aus: Gerät &gt; Kräfte an.</translation>
        </message>
        <message>
            <source>Lock %1</source>
            <translation>%1 sperren</translation>
        </message>
        <message>
            <source>Lock: no edit changes how it feels or which triangles it has (L)</source>
            <translation>Sperren: Keine Änderung betrifft Haptik oder Dreiecke (L)</translation>
        </message>
        <message>
            <source>Locked: press L to unlock.</source>
            <translation>Gesperrt: L drücken zum Entsperren.</translation>
        </message>
        <message>
            <source>Log every</source>
            <translation>Protokoll alle</translation>
        </message>
        <message>
            <source>Longest side</source>
            <translation>Längste Seite</translation>
        </message>
        <message>
            <source>Loo&amp;k</source>
            <translation>Darstellungs&amp;weise</translation>
        </message>
        <message>
            <source>Look</source>
            <translation>Aussehen</translation>
        </message>
        <message>
            <source>Look at its cable and its power, then arm again.</source>
            <translation>Kabel und Stromversorgung prüfen, dann Kräfte wieder einschalten.</translation>
        </message>
        <message>
            <source>Look from %1</source>
            <translation>Blick von %1</translation>
        </message>
        <message>
            <source>Look from above</source>
            <translation>Von oben sehen</translation>
        </message>
        <message>
            <source>Look from further above</source>
            <translation>Von weiter oben sehen</translation>
        </message>
        <message>
            <source>Look from further below</source>
            <translation>Von weiter unten sehen</translation>
        </message>
        <message>
            <source>Look from further left</source>
            <translation>Von weiter links sehen</translation>
        </message>
        <message>
            <source>Look from further right</source>
            <translation>Von weiter rechts sehen</translation>
        </message>
        <message>
            <source>Look from the corner between them</source>
            <translation>Von der Ecke dazwischen sehen</translation>
        </message>
        <message>
            <source>Look from the front</source>
            <translation>Von vorn sehen</translation>
        </message>
        <message>
            <source>Look from the right</source>
            <translation>Von rechts sehen</translation>
        </message>
        <message>
            <source>Looking for devices...</source>
            <translation>Geräte werden gesucht...</translation>
        </message>
        <message>
            <source>Looking which triangles lie there</source>
            <translation>Dort liegende Dreiecke werden gesucht</translation>
        </message>
        <message>
            <source>Loops</source>
            <translation>Schleifen</translation>
        </message>
        <message>
            <source>Loose</source>
            <translation>Lose</translation>
        </message>
        <message>
            <source>Loose balls: push one, and it meets the others</source>
            <translation>Lose Kugeln: eine anstoßen, und sie trifft die anderen</translation>
        </message>
        <message>
            <source>Loupe</source>
            <translation>Lupe</translation>
        </message>
        <message>
            <source>Lower stop</source>
            <translation>Unterer Anschlag</translation>
        </message>
        <message>
            <source>Make the chosen device ready as one more hand; those that there are stay</source>
            <translation>Das gewählte Gerät als weitere Hand bereit machen; die vorhandenen bleiben</translation>
        </message>
        <message>
            <source>Make the chosen device ready, step by step</source>
            <translation>Das gewählte Gerät Schritt für Schritt bereit machen</translation>
        </message>
        <message>
            <source>Make the device that is chosen in the dock Device ready as one more hand</source>
            <translation>Das im Bereich Gerät gewählte Gerät als weitere Hand bereit machen</translation>
        </message>
        <message>
            <source>Make the device that is chosen in the dock Device ready, step by step</source>
            <translation>Das im Bereich Gerät gewählte Gerät Schritt für Schritt bereit machen</translation>
        </message>
        <message>
            <source>Making %1 ready</source>
            <translation>%1 wird bereit gemacht</translation>
        </message>
        <message>
            <source>Mapping</source>
            <translation>Abbildung</translation>
        </message>
        <message>
            <source>Mapping radius</source>
            <translation>Abbildungsradius</translation>
        </message>
        <message>
            <source>Mark as A</source>
            <translation>Als A markieren</translation>
        </message>
        <message>
            <source>Mark the scene as A, then edit it.</source>
            <translation>Szene als A markieren, dann bearbeiten.</translation>
        </message>
        <message>
            <source>Mask</source>
            <translation>Maske</translation>
        </message>
        <message>
            <source>Mask of layer</source>
            <translation>Maske der Ebene</translation>
        </message>
        <message>
            <source>Mass</source>
            <translation>Masse</translation>
        </message>
        <message>
            <source>Material, shading, sides and layers of the active surface, to be pasted onto others</source>
            <translation>Material, Shading, Seiten und Ebenen der aktiven Oberfläche, um sie auf andere einzufügen</translation>
        </message>
        <message>
            <source>Mean friction ratio</source>
            <translation>Mittleres Reibungsverhältnis</translation>
        </message>
        <message>
            <source>Meas&amp;ure</source>
            <translation>M&amp;essen</translation>
        </message>
        <message>
            <source>Measure the device in about ten minutes: what it really is, and what about it is wrong</source>
            <translation>Das Gerät in etwa zehn Minuten vermessen: was es wirklich ist, und was an ihm falsch ist</translation>
        </message>
        <message>
            <source>Measure: two clicks on the model are a distance, a third gives the angle at the second; Esc ends it</source>
            <translation>Messen: zwei Klicks auf das Modell sind ein Abstand, ein dritter ergibt den Winkel am zweiten; Esc beendet es</translation>
        </message>
        <message>
            <source>Measured by, taken from; empty: set by hand</source>
            <translation>Gemessen von, entnommen aus; leer: von Hand gesetzt</translation>
        </message>
        <message>
            <source>Merge %1</source>
            <translation>%1 vereinigen</translation>
        </message>
        <message>
            <source>Met as</source>
            <translation>Kollision</translation>
        </message>
        <message>
            <source>Metal</source>
            <translation>Metall</translation>
        </message>
        <message>
            <source>Metal on wood</source>
            <translation>Metall auf Holz</translation>
        </message>
        <message>
            <source>Metres</source>
            <translation>Meter</translation>
        </message>
        <message>
            <source>Metres of the scene to a metre of the handle: 2 lets a small device reach twice as far, 0.1 feels what is fine. A spring of the scene feels stiffer by as much, so the stiffness ceiling falls by it.</source>
            <translation>Meter der Szene für einen Meter des Griffs: Mit 2 reicht ein kleines Gerät doppelt so weit, mit 0.1 wird Feines fühlbar. Eine Feder der Szene fühlt sich um ebenso viel steifer an, daher sinkt die Steifigkeitsgrenze entsprechend.</translation>
        </message>
        <message>
            <source>Middle drag, Alt+drag</source>
            <translation>Ziehen mit mittlerer Taste, Alt+Ziehen</translation>
        </message>
        <message>
            <source>Middle moves, Shift+middle turns</source>
            <translation>Mitte verschiebt, Umschalt+Mitte dreht</translation>
        </message>
        <message>
            <source>Middle of all</source>
            <translation>Mitte aller</translation>
        </message>
        <message>
            <source>Middle turns, Shift+middle moves</source>
            <translation>Mitte dreht, Umschalt+Mitte verschiebt</translation>
        </message>
        <message>
            <source>Millimetres</source>
            <translation>Millimeter</translation>
        </message>
        <message>
            <source>Model and finger</source>
            <translation>Modell und Finger</translation>
        </message>
        <message>
            <source>Models (%1)</source>
            <translation>Modelle (%1)</translation>
        </message>
        <message>
            <source>Models and recordings (%1 %2);;Models (%1);;Recordings (%2)</source>
            <translation>Modelle und Aufnahmen (%1 %2);;Modelle (%1);;Aufnahmen (%2)</translation>
        </message>
        <message>
            <source>Models from files, beside what is in the scene; dropping files on the window does the same</source>
            <translation>Modelle aus Dateien, neben dem, was in der Szene ist; Dateien auf dem Fenster abzulegen tut dasselbe</translation>
        </message>
        <message>
            <source>Motion</source>
            <translation>Bewegung</translation>
        </message>
        <message>
            <source>Motor force</source>
            <translation>Motorkraft</translation>
        </message>
        <message>
            <source>Motor speed</source>
            <translation>Motortempo</translation>
        </message>
        <message>
            <source>Motor torque</source>
            <translation>Motormoment</translation>
        </message>
        <message>
            <source>Motors</source>
            <translation>Motoren</translation>
        </message>
        <message>
            <source>Mouse and camera</source>
            <translation>Maus und Kamera</translation>
        </message>
        <message>
            <source>Mouse, units, theme, language and what is kept for a crash</source>
            <translation>Maus, Einheiten, Design, Sprache und was für einen Absturz gesichert wird</translation>
        </message>
        <message>
            <source>Move %1</source>
            <translation>%1 verschieben</translation>
        </message>
        <message>
            <source>Move layer %1</source>
            <translation>Ebene %1 verschieben</translation>
        </message>
        <message>
            <source>Move layer d&amp;own</source>
            <translation>Ebene nach &amp;unten</translation>
        </message>
        <message>
            <source>Move layer u&amp;p</source>
            <translation>Ebene nach &amp;oben</translation>
        </message>
        <message>
            <source>Move the finger slowly for a moment.</source>
            <translation>Den Finger einen Moment lang langsam bewegen.</translation>
        </message>
        <message>
            <source>Move the handle to the right, up and toward you: the axes follow from that</source>
            <translation>Griff nach rechts, nach oben und zu sich hin bewegen: Daraus folgen die Achsen</translation>
        </message>
        <message>
            <source>Move, turn and scale: click an object and drag its handles; G, R and S take hold of it</source>
            <translation>Verschieben, drehen und skalieren: ein Objekt anklicken und seine Anfasser ziehen; G, R und S greifen es</translation>
        </message>
        <message>
            <source>Moving pictures</source>
            <translation>Bewegte Bilder</translation>
        </message>
        <message>
            <source>Multiply</source>
            <translation>Multiplizieren</translation>
        </message>
        <message>
            <source>N/m</source>
            <translation>N/m</translation>
        </message>
        <message>
            <source>N/mm</source>
            <translation>N/mm</translation>
        </message>
        <message>
            <source>Name</source>
            <translation>Name</translation>
        </message>
        <message>
            <source>Name of the camera</source>
            <translation>Name der Kamera</translation>
        </message>
        <message>
            <source>Name of the condition</source>
            <translation>Name der Bedingung</translation>
        </message>
        <message>
            <source>Name of the layer</source>
            <translation>Name der Ebene</translation>
        </message>
        <message>
            <source>Name of the set</source>
            <translation>Name des Satzes</translation>
        </message>
        <message>
            <source>Ne&amp;w scene</source>
            <translation>&amp;Neue Szene</translation>
        </message>
        <message>
            <source>Needles along the normals that are felt; the view says where they are not those that are drawn</source>
            <translation>Nadeln entlang der gefühlten Normalen; die Ansicht sagt, wo es nicht die gezeichneten sind</translation>
        </message>
        <message>
            <source>Neighbours of the object get their fronts on the same side, closed parts outside</source>
            <translation>Nachbarn des Objekts bekommen ihre Vorderseiten auf derselben Seite, geschlossene Teile außen</translation>
        </message>
        <message>
            <source>Never more than four tenths of the device's force is used, and a handle that is too fast gets none. Cancel or Esc ends the test at any time: the force is gone at once.</source>
            <translation>Nie wird mehr als vier Zehntel der Kraft des Geräts benutzt, und ein Griff, der zu schnell ist, bekommt keine. Abbrechen oder Esc beendet den Test jederzeit: Die Kraft ist sofort weg.</translation>
        </message>
        <message>
            <source>New scene</source>
            <translation>Neue Szene</translation>
        </message>
        <message>
            <source>New scene on a &amp;ground</source>
            <translation>Neue Szene mit B&amp;oden</translation>
        </message>
        <message>
            <source>Newtons on a body for each of the finger's: small for a micro-sensor, large for a windmill.</source>
            <translation>Newton auf einen Körper für jedes des Fingers: klein für einen Mikrosensor, groß für eine Windmühle.</translation>
        </message>
        <message>
            <source>Next (Space)</source>
            <translation>Weiter (Leertaste)</translation>
        </message>
        <message>
            <source>No</source>
            <translation>Nein</translation>
        </message>
        <message>
            <source>No button</source>
            <translation>Keine Taste</translation>
        </message>
        <message>
            <source>No button is held</source>
            <translation>Keine Taste wird gehalten</translation>
        </message>
        <message>
            <source>No buttons</source>
            <translation>Keine Tasten</translation>
        </message>
        <message>
            <source>No command fits; leave some letters out.</source>
            <translation>Kein Befehl passt; ein paar Buchstaben weglassen.</translation>
        </message>
        <message>
            <source>No condition is chosen in the dock Study.</source>
            <translation>Im Bereich Studie ist keine Bedingung gewählt.</translation>
        </message>
        <message>
            <source>No condition yet. Make the scene feel as one should, then keep this state.</source>
            <translation>Noch keine Bedingung. Die Szene so einrichten, wie sich eine anfühlen soll, dann den Zustand festhalten.</translation>
        </message>
        <message>
            <source>No device gives more, whatever it can and whatever a scene asks for; 0 is as much as it can. Counts for a device from when it is connected, for the simulated hand from the next start on.</source>
            <translation>Kein Gerät gibt mehr, was es auch kann und was eine Szene auch verlangt; 0 ist so viel, wie es kann. Gilt für ein Gerät, sobald es verbunden wird, für die simulierte Hand ab dem nächsten Start.</translation>
        </message>
        <message>
            <source>No device is chosen.</source>
            <translation>Es ist kein Gerät gewählt.</translation>
        </message>
        <message>
            <source>No device is connected, and a simulated hand has nothing to be measured.</source>
            <translation>Kein Gerät ist verbunden, und an einer simulierten Hand gibt es nichts zu messen.</translation>
        </message>
        <message>
            <source>No device is connected.</source>
            <translation>Kein Gerät ist verbunden.</translation>
        </message>
        <message>
            <source>No difference</source>
            <translation>Keine Differenz</translation>
        </message>
        <message>
            <source>No edit changes how the selected surfaces feel or which triangles they have; the same unlocks</source>
            <translation>Keine Änderung betrifft, wie sich die gewählten Oberflächen anfühlen oder welche Dreiecke sie haben; derselbe Befehl entsperrt</translation>
        </message>
        <message>
            <source>No edit was taken back.</source>
            <translation>Keine Änderung wurde rückgängig gemacht.</translation>
        </message>
        <message>
            <source>No figure was measured that a profile has.</source>
            <translation>Es wurde keine Größe gemessen, die ein Profil hat.</translation>
        </message>
        <message>
            <source>No file was opened yet</source>
            <translation>Noch keine Datei geöffnet</translation>
        </message>
        <message>
            <source>No force shading: every facet is felt as it is</source>
            <translation>Kein Kraft-Shading: Jede Facette wird gefühlt, wie sie ist</translation>
        </message>
        <message>
            <source>No gamepad that vibrates is connected</source>
            <translation>Kein Gamepad, das vibriert, ist angeschlossen</translation>
        </message>
        <message>
            <source>No gamepad that vibrates is connected; one that is plugged in vibrates at once.</source>
            <translation>Kein Gamepad, das vibriert, ist angeschlossen; eines, das eingesteckt wird, vibriert sofort.</translation>
        </message>
        <message>
            <source>No key and no gesture has these words.</source>
            <translation>Keine Taste und keine Geste hat diese Wörter.</translation>
        </message>
        <message>
            <source>No layer is selected that can be edited.</source>
            <translation>Keine Ebene ist gewählt, die bearbeitet werden kann.</translation>
        </message>
        <message>
            <source>No layer is selected whose mapping has a frame; choose Triplanar, Planar or a round one.</source>
            <translation>Keine Ebene ist gewählt, deren Abbildung einen Rahmen hat; Triplanar, Planar oder eine runde wählen.</translation>
        </message>
        <message>
            <source>No layer lies above the selected one.</source>
            <translation>Über der gewählten liegt keine Ebene.</translation>
        </message>
        <message>
            <source>No layer lies beneath the selected one.</source>
            <translation>Unter der gewählten liegt keine Ebene.</translation>
        </message>
        <message>
            <source>No layer yet. Add one with the button above, or drop a picture (PNG, JPEG, TIFF) on the model or here.</source>
            <translation>Noch keine Ebene. Eine mit der Schaltfläche oben hinzufügen oder ein Bild (PNG, JPEG, TIFF) auf dem Modell oder hier ablegen.</translation>
        </message>
        <message>
            <source>No layers yet. Add one (+).</source>
            <translation>Noch keine Ebenen. Eine hinzufügen (+).</translation>
        </message>
        <message>
            <source>No object selected</source>
            <translation>Kein Objekt gewählt</translation>
        </message>
        <message>
            <source>No page has these words.</source>
            <translation>Keine Seite hat diese Wörter.</translation>
        </message>
        <message>
            <source>No picture</source>
            <translation>Kein Bild</translation>
        </message>
        <message>
            <source>No preset fits. Clear the search, or save one of your own from a selected surface.</source>
            <translation>Keine Vorgabe passt. Suche leeren oder eine eigene von einer gewählten Oberfläche speichern.</translation>
        </message>
        <message>
            <source>No preset is chosen in the library, or no surface is selected.</source>
            <translation>Keine Vorgabe ist in der Bibliothek gewählt, oder keine Oberfläche ist gewählt.</translation>
        </message>
        <message>
            <source>No preset is chosen in the library.</source>
            <translation>Keine Vorgabe ist in der Bibliothek gewählt.</translation>
        </message>
        <message>
            <source>No preset is chosen.</source>
            <translation>Keine Vorgabe ist gewählt.</translation>
        </message>
        <message>
            <source>No problems found. What is doubtful about a mesh or a value will be listed here.</source>
            <translation>Keine Probleme gefunden. Was an einem Netz oder einem Wert zweifelhaft ist, wird hier aufgeführt.</translation>
        </message>
        <message>
            <source>No program shows pages here; the report is %1.</source>
            <translation>Kein Programm zeigt hier Seiten an; der Bericht ist %1.</translation>
        </message>
        <message>
            <source>No selection is kept yet</source>
            <translation>Noch ist keine Auswahl behalten</translation>
        </message>
        <message>
            <source>No smooth curve goes through these points; move them farther apart.</source>
            <translation>Durch diese Punkte geht keine glatte Kurve; sie weiter auseinanderziehen.</translation>
        </message>
        <message>
            <source>No state was marked as A.</source>
            <translation>Kein Zustand wurde als A markiert.</translation>
        </message>
        <message>
            <source>No stroke was recorded: the device has not run. Start it first.</source>
            <translation>Es wurde kein Strich aufgenommen: Das Gerät ist nicht gelaufen. Zuerst starten.</translation>
        </message>
        <message>
            <source>No surface</source>
            <translation>Keine Oberfläche</translation>
        </message>
        <message>
            <source>No surface and no triangle</source>
            <translation>Keine Oberfläche und kein Dreieck</translation>
        </message>
        <message>
            <source>No surface is selected.</source>
            <translation>Keine Oberfläche ist gewählt.</translation>
        </message>
        <message>
            <source>No surface selected</source>
            <translation>Keine Oberfläche gewählt</translation>
        </message>
        <message>
            <source>No triangles are selected but whole surfaces at most; take some by box, lasso or brush.</source>
            <translation>Keine Dreiecke sind gewählt, höchstens ganze Oberflächen; einige mit Rechteck, Lasso oder Pinsel nehmen.</translation>
        </message>
        <message>
            <source>No view is kept yet</source>
            <translation>Noch ist keine Ansicht gespeichert</translation>
        </message>
        <message>
            <source>Nobody holds a simulated hand.</source>
            <translation>Eine simulierte Hand hält niemand.</translation>
        </message>
        <message>
            <source>Noise</source>
            <translation>Rauschen</translation>
        </message>
        <message>
            <source>None</source>
            <translation>Keine</translation>
        </message>
        <message>
            <source>None of these, or several</source>
            <translation>Keine davon oder mehrere</translation>
        </message>
        <message>
            <source>Normal (replace)</source>
            <translation>Normal (ersetzen)</translation>
        </message>
        <message>
            <source>Normals felt as drawn</source>
            <translation>Normalen gefühlt wie gezeichnet</translation>
        </message>
        <message>
            <source>Normals felt: %1, up to %2° from those drawn</source>
            <translation>Gefühlte Normalen: %1, bis zu %2° neben den gezeichneten</translation>
        </message>
        <message>
            <source>Normals of the file for %1</source>
            <translation>Normalen der Datei für %1</translation>
        </message>
        <message>
            <source>Normals: being read</source>
            <translation>Normalen: werden gelesen</translation>
        </message>
        <message>
            <source>Not connected to %1: no force</source>
            <translation>Nicht mit %1 verbunden: keine Kraft</translation>
        </message>
        <message>
            <source>Not done at %1: %2.</source>
            <translation>Auf %1 nicht ausgeführt: %2.</translation>
        </message>
        <message>
            <source>Not now: %1 %2</source>
            <translation>Jetzt nicht: %1 %2</translation>
        </message>
        <message>
            <source>Not there since last time: %1. What you plug in is made ready by itself.</source>
            <translation>Seit dem letzten Mal nicht mehr da: %1. Was Sie anschließen, wird von selbst bereit gemacht.</translation>
        </message>
        <message>
            <source>Note</source>
            <translation>Hinweis</translation>
        </message>
        <message>
            <source>Nothing has been touched yet: drag on the model.</source>
            <translation>Noch nichts berührt: auf dem Modell ziehen.</translation>
        </message>
        <message>
            <source>Nothing has taken the force away so far. What does will be listed here.</source>
            <translation>Bisher hat nichts die Kraft weggenommen. Was sie wegnimmt, wird hier aufgeführt.</translation>
        </message>
        <message>
            <source>Nothing has “%1” in its name.</source>
            <translation>Nichts hat „%1“ im Namen.</translation>
        </message>
        <message>
            <source>Nothing is asked of the participant; questions are in Procedure.</source>
            <translation>Die teilnehmende Person wird nichts gefragt; Fragen stehen unter „Ablauf“.</translation>
        </message>
        <message>
            <source>Nothing is left out.</source>
            <translation>Nichts ist ausgelassen.</translation>
        </message>
        <message>
            <source>Nothing is open, or the scene is empty.</source>
            <translation>Nichts ist geöffnet, oder die Szene ist leer.</translation>
        </message>
        <message>
            <source>Nothing is painted yet, so it is not felt.</source>
            <translation>Es ist noch nichts gemalt und daher nichts zu fühlen.</translation>
        </message>
        <message>
            <source>Nothing is selected; click an object first.</source>
            <translation>Nichts ist gewählt; zuerst ein Objekt anklicken.</translation>
        </message>
        <message>
            <source>Nothing is selected; select the object first (Q).</source>
            <translation>Nichts ist gewählt; zuerst das Objekt auswählen (Q).</translation>
        </message>
        <message>
            <source>Nothing of a group is selected.</source>
            <translation>Nichts aus einer Gruppe ist ausgewählt.</translation>
        </message>
        <message>
            <source>Nothing was changed.</source>
            <translation>Nichts wurde geändert.</translation>
        </message>
        <message>
            <source>Nothing was changed: it feels like %1 already.</source>
            <translation>Nichts wurde geändert: Es fühlt sich schon an wie %1.</translation>
        </message>
        <message>
            <source>Nothing was changed: locked surfaces stay as they are. Unlock them (L).</source>
            <translation>Nichts wurde geändert: Gesperrte Oberflächen bleiben, wie sie sind. Zuerst entsperren (L).</translation>
        </message>
        <message>
            <source>Nothing was compared yet.</source>
            <translation>Es wurde noch nichts verglichen.</translation>
        </message>
        <message>
            <source>Nothing was recorded yet: the device has not run. Start it first.</source>
            <translation>Es wurde noch nichts aufgenommen: Das Gerät ist nicht gelaufen. Zuerst starten.</translation>
        </message>
        <message>
            <source>Nothing wrong was found.</source>
            <translation>Es wurde nichts Falsches gefunden.</translation>
        </message>
        <message>
            <source>Numbers</source>
            <translation>Zahlen</translation>
        </message>
        <message>
            <source>Object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>Octaves</source>
            <translation>Oktaven</translation>
        </message>
        <message>
            <source>Of its own box; the other sides keep the proportion.</source>
            <translation>Des eigenen Quaders; die anderen Seiten behalten das Verhältnis.</translation>
        </message>
        <message>
            <source>Of presets</source>
            <translation>Aus Vorgaben</translation>
        </message>
        <message>
            <source>Of text, icons and fields, as part of what the screen asks for.</source>
            <translation>Von Text, Symbolen und Feldern, als Teil dessen, was der Bildschirm verlangt.</translation>
        </message>
        <message>
            <source>Of the &amp;object</source>
            <translation>Des &amp;Objekts</translation>
        </message>
        <message>
            <source>Of the &amp;world</source>
            <translation>Der &amp;Welt</translation>
        </message>
        <message>
            <source>Of the window. Messages about files and devices, the guide and the command line are in English.</source>
            <translation>Des Fensters. Meldungen über Dateien und Geräte, das Handbuch und die Befehlszeile sind auf Englisch.</translation>
        </message>
        <message>
            <source>Off</source>
            <translation>Aus</translation>
        </message>
        <message>
            <source>Off: normals are computed, and edges beyond the crease angle stay sharp.</source>
            <translation>Aus: Normalen werden berechnet, und Kanten über dem Knickwinkel bleiben scharf.</translation>
        </message>
        <message>
            <source>Off: the layer joins those below it, and one plane leans as they do together. On: a plane for this layer alone (section 4.3).</source>
            <translation>Aus: Die Ebene verbindet sich mit denen darunter, und eine Zwangsebene neigt sich, wie sie es zusammen tun. An: eine Zwangsebene für diese Ebene allein (Abschnitt 4.3).</translation>
        </message>
        <message>
            <source>Offset u</source>
            <translation>Versatz u</translation>
        </message>
        <message>
            <source>Offset v</source>
            <translation>Versatz v</translation>
        </message>
        <message>
            <source>On</source>
            <translation>Ein</translation>
        </message>
        <message>
            <source>On a &amp;hinge</source>
            <translation>An einem Sc&amp;harnier</translation>
        </message>
        <message>
            <source>On a &amp;path</source>
            <translation>Auf einer &amp;Bahn</translation>
        </message>
        <message>
            <source>On a sl&amp;ider</source>
            <translation>Auf einer Sch&amp;iene</translation>
        </message>
        <message>
            <source>On: the brush paints the mask. Off: it paints the layer itself.</source>
            <translation>An: Der Pinsel malt die Maske. Aus: Er malt die Ebene selbst.</translation>
        </message>
        <message>
            <source>On: the finger lags behind the mouse against a force and hurries with one, and the pointer is hidden meanwhile. The eye feels friction and bumps without a device.</source>
            <translation>Ein: Der Finger bleibt gegen eine Kraft hinter der Maus zurück und eilt mit ihr voraus; der Zeiger ist solange verborgen. Das Auge fühlt Reibung und Unebenheiten ohne Gerät.</translation>
        </message>
        <message>
            <source>One blow goes through all of them</source>
            <translation>Ein Stoß geht durch alle hindurch</translation>
        </message>
        <message>
            <source>One file with the conditions in it</source>
            <translation>Eine Datei mit den Bedingungen darin</translation>
        </message>
        <message>
            <source>One hull</source>
            <translation>Eine Hülle</translation>
        </message>
        <message>
            <source>One level &amp;coarser</source>
            <translation>Eine Stufe &amp;gröber</translation>
        </message>
        <message>
            <source>One level &amp;finer</source>
            <translation>Eine Stufe &amp;feiner</translation>
        </message>
        <message>
            <source>One moment.</source>
            <translation>Einen Moment, bitte.</translation>
        </message>
        <message>
            <source>One more joint of %1</source>
            <translation>Ein weiteres Gelenk von %1</translation>
        </message>
        <message>
            <source>One more joint, as those that close a loop</source>
            <translation>Ein weiteres Gelenk, wie eines, das einen Kreis schließt</translation>
        </message>
        <message>
            <source>One page with pictures, values, their sources and the forces of a stroke, as HTML or PDF</source>
            <translation>Eine Seite mit Bildern, Werten, deren Quellen und den Kräften eines Strichs, als HTML oder PDF</translation>
        </message>
        <message>
            <source>One ring of triangles less</source>
            <translation>Ein Ring von Dreiecken weniger</translation>
        </message>
        <message>
            <source>One ring of triangles more</source>
            <translation>Ein Ring von Dreiecken mehr</translation>
        </message>
        <message>
            <source>One st&amp;ep</source>
            <translation>Ein &amp;Schritt</translation>
        </message>
        <message>
            <source>One unit of the file is 1 cm</source>
            <translation>Eine Einheit der Datei ist 1 cm</translation>
        </message>
        <message>
            <source>One unit of the file is 1 in</source>
            <translation>Eine Einheit der Datei ist 1 in</translation>
        </message>
        <message>
            <source>One unit of the file is 1 mm</source>
            <translation>Eine Einheit der Datei ist 1 mm</translation>
        </message>
        <message>
            <source>One zip for other programs: glTF, X3D for H3D, images, a finger path with its forces, a report</source>
            <translation>Ein Zip für andere Programme: glTF, X3D für H3D, Bilder, eine Fingerbahn mit ihren Kräften, ein Bericht</translation>
        </message>
        <message>
            <source>Only objects and surfaces with this in their names; Enter selects them</source>
            <translation>Nur Objekte und Oberflächen, deren Name dies enthält; Eingabe wählt sie aus</translation>
        </message>
        <message>
            <source>Only the nearest planes are felt: the scene is too heavy.</source>
            <translation>Nur die nächsten Zwangsebenen werden gefühlt: Die Szene ist zu schwer.</translation>
        </message>
        <message>
            <source>Opacity</source>
            <translation>Deckkraft</translation>
        </message>
        <message>
            <source>Ope&amp;n recent</source>
            <translation>&amp;Zuletzt geöffnet</translation>
        </message>
        <message>
            <source>Open a 3-D model, give each of its surfaces a feel, and touch it: with a force-feedback device, or with the mouse as a simulated hand.</source>
            <translation>Ein 3D-Modell öffnen, jeder seiner Oberflächen eine Haptik geben und es berühren: mit einem Kraftrückkopplungsgerät oder mit der Maus als simulierter Hand.</translation>
        </message>
        <message>
            <source>Open a model or a recording</source>
            <translation>Modell oder Aufnahme öffnen</translation>
        </message>
        <message>
            <source>Open a model...</source>
            <translation>Modell öffnen...</translation>
        </message>
        <message>
            <source>Open a scene, a model or a recording</source>
            <translation>Szene, Modell oder Aufnahme öffnen</translation>
        </message>
        <message>
            <source>Open a study</source>
            <translation>Studie öffnen</translation>
        </message>
        <message>
            <source>Open again</source>
            <translation>Erneut öffnen</translation>
        </message>
        <message>
            <source>Open it alone</source>
            <translation>Allein öffnen</translation>
        </message>
        <message>
            <source>Open recent %1</source>
            <translation>Zuletzt geöffnet: %1</translation>
        </message>
        <message>
            <source>Opening</source>
            <translation>Öffnen</translation>
        </message>
        <message>
            <source>Opening the recording</source>
            <translation>Aufnahme wird geöffnet</translation>
        </message>
        <message>
            <source>Opens it as it was, with unsaved changes; its file stays as it is</source>
            <translation>Öffnet sie, wie sie war, mit ungespeicherten Änderungen; ihre Datei bleibt, wie sie ist</translation>
        </message>
        <message>
            <source>Order</source>
            <translation>Reihenfolge</translation>
        </message>
        <message>
            <source>Order &amp;in the list</source>
            <translation>Reihenfol&amp;ge in der Liste</translation>
        </message>
        <message>
            <source>Origin</source>
            <translation>Ursprung</translation>
        </message>
        <message>
            <source>Other side</source>
            <translation>Andere Seite</translation>
        </message>
        <message>
            <source>Outliner</source>
            <translation>Szenenliste</translation>
        </message>
        <message>
            <source>Own plane</source>
            <translation>Eigene Zwangsebene</translation>
        </message>
        <message>
            <source>Own view</source>
            <translation>Eigene Ansicht</translation>
        </message>
        <message>
            <source>P&amp;late</source>
            <translation>&amp;Platte</translation>
        </message>
        <message>
            <source>Page %1</source>
            <translation>Seite %1</translation>
        </message>
        <message>
            <source>Page of the guide</source>
            <translation>Seite des Handbuchs</translation>
        </message>
        <message>
            <source>Pages</source>
            <translation>Seiten</translation>
        </message>
        <message>
            <source>Pages of the guide</source>
            <translation>Seiten des Handbuchs</translation>
        </message>
        <message>
            <source>Paint %1 of %2</source>
            <translation>Malen: %1 auf %2</translation>
        </message>
        <message>
            <source>Paint the mask</source>
            <translation>Maske malen</translation>
        </message>
        <message>
            <source>Paint: drag on the model to lay a value or a mask onto it; Ctrl takes away, Shift smooths</source>
            <translation>Malen: auf dem Modell ziehen, um einen Wert oder eine Maske aufzutragen; Strg nimmt weg, Umschalt glättet</translation>
        </message>
        <message>
            <source>Painted</source>
            <translation>Gemalt</translation>
        </message>
        <message>
            <source>Painted by you</source>
            <translation>Selbst gemalt</translation>
        </message>
        <message>
            <source>Pairs, the better one is chosen</source>
            <translation>Paare, das bessere wird gewählt</translation>
        </message>
        <message>
            <source>Pairs: one of two is chosen</source>
            <translation>Paare: eines von zweien wird gewählt</translation>
        </message>
        <message>
            <source>Panel %1</source>
            <translation>Bereich %1</translation>
        </message>
        <message>
            <source>Paper</source>
            <translation>Papier</translation>
        </message>
        <message>
            <source>Parameter</source>
            <translation>Parameter</translation>
        </message>
        <message>
            <source>Part %1 of %2: %3</source>
            <translation>Teil %1 von %2: %3</translation>
        </message>
        <message>
            <source>Part of the radius over which the effect fades to nothing: 0 is a hard edge, at 1 it fades from the middle.</source>
            <translation>Teil des Radius, über den die Wirkung auf nichts ausläuft: 0 ist eine harte Kante, bei 1 läuft sie ab der Mitte aus.</translation>
        </message>
        <message>
            <source>Paste &amp;feel</source>
            <translation>Haptik e&amp;infügen</translation>
        </message>
        <message>
            <source>Paste the feel onto %1</source>
            <translation>Haptik auf %1 einfügen</translation>
        </message>
        <message>
            <source>Path</source>
            <translation>Bahn</translation>
        </message>
        <message>
            <source>Pattern</source>
            <translation>Muster</translation>
        </message>
        <message>
            <source>Patterns</source>
            <translation>Muster</translation>
        </message>
        <message>
            <source>Pause (Space)</source>
            <translation>Pause (Leertaste)</translation>
        </message>
        <message>
            <source>Pause after a trial</source>
            <translation>Pause nach einem Durchgang</translation>
        </message>
        <message>
            <source>Pause the force plot</source>
            <translation>Kraftdiagramm anhalten</translation>
        </message>
        <message>
            <source>Periods</source>
            <translation>Perioden</translation>
        </message>
        <message>
            <source>Pick points</source>
            <translation>Punkte setzen</translation>
        </message>
        <message>
            <source>Picture</source>
            <translation>Bild</translation>
        </message>
        <message>
            <source>Pictures</source>
            <translation>Bilder</translation>
        </message>
        <message>
            <source>Pictures (*.png *.jpg *.jpeg *.tif *.tiff)</source>
            <translation>Bilder (*.png *.jpg *.jpeg *.tif *.tiff)</translation>
        </message>
        <message>
            <source>Place</source>
            <translation>Lage</translation>
        </message>
        <message>
            <source>Place of the plane along its normal</source>
            <translation>Ort der Ebene längs ihrer Normalen</translation>
        </message>
        <message>
            <source>Place x</source>
            <translation>Ort x</translation>
        </message>
        <message>
            <source>Place y</source>
            <translation>Ort y</translation>
        </message>
        <message>
            <source>Place z</source>
            <translation>Ort z</translation>
        </message>
        <message>
            <source>Planar</source>
            <translation>Planar</translation>
        </message>
        <message>
            <source>Plastic</source>
            <translation>Kunststoff</translation>
        </message>
        <message>
            <source>Play (Space)</source>
            <translation>Abspielen (Leertaste)</translation>
        </message>
        <message>
            <source>Play or pause the recording</source>
            <translation>Aufnahme abspielen oder anhalten</translation>
        </message>
        <message>
            <source>Position</source>
            <translation>Position</translation>
        </message>
        <message>
            <source>Pre&amp;vious panel</source>
            <translation>Vor&amp;iger Bereich</translation>
        </message>
        <message>
            <source>Preferen&amp;ces...</source>
            <translation>Ein&amp;stellungen...</translation>
        </message>
        <message>
            <source>Preferences</source>
            <translation>Einstellungen</translation>
        </message>
        <message>
            <source>Preparing the surfaces for touch</source>
            <translation>Oberflächen werden zum Berühren vorbereitet</translation>
        </message>
        <message>
            <source>Presentation displa&amp;y</source>
            <translation>Präsentationsan&amp;zeige</translation>
        </message>
        <message>
            <source>Preset %1</source>
            <translation>Vorgabe %1</translation>
        </message>
        <message>
            <source>Presets</source>
            <translation>Vorgaben</translation>
        </message>
        <message>
            <source>Presets and texture models (*.%1 *.xml);;Presets (*.%1);;Texture models of the Penn toolkit (*.xml)</source>
            <translation>Vorgaben und Texturmodelle (*.%1 *.xml);;Vorgaben (*.%1);;Texturmodelle des Penn-Toolkits (*.xml)</translation>
        </message>
        <message>
            <source>Presets from files, or texture models (.xml) of your own copy of the Penn Haptic Texture Toolkit</source>
            <translation>Vorgaben aus Dateien oder Texturmodelle (.xml) Ihrer eigenen Kopie des Penn Haptic Texture Toolkit</translation>
        </message>
        <message>
            <source>Presets, problems and history to their tabs, so that the scene has their room</source>
            <translation>Vorgaben, Probleme und Verlauf auf ihre Reiter, damit die Szene ihren Platz hat</translation>
        </message>
        <message>
            <source>Printed pages</source>
            <translation>Gedruckte Seiten</translation>
        </message>
        <message>
            <source>Problems</source>
            <translation>Probleme</translation>
        </message>
        <message>
            <source>Problems  %1</source>
            <translation>Probleme  %1</translation>
        </message>
        <message>
            <source>Procedure</source>
            <translation>Ablauf</translation>
        </message>
        <message>
            <source>Procedure and questions</source>
            <translation>Ablauf und Fragen</translation>
        </message>
        <message>
            <source>Procedure...</source>
            <translation>Ablauf...</translation>
        </message>
        <message>
            <source>Proxy</source>
            <translation>Proxy</translation>
        </message>
        <message>
            <source>Proxy lag</source>
            <translation>Proxyrückstand</translation>
        </message>
        <message>
            <source>Proxy loop: updates a second, and the mean time of one</source>
            <translation>Proxyschleife: Aktualisierungen je Sekunde und die mittlere Zeit für eine</translation>
        </message>
        <message>
            <source>Proxy radius</source>
            <translation>Proxyradius</translation>
        </message>
        <message>
            <source>Pseudo-haptic mouse</source>
            <translation>Pseudohaptische Maus</translation>
        </message>
        <message>
            <source>Push the car back along its track against the thrust</source>
            <translation>Den Wagen gegen den Schub auf seiner Bahn zurückschieben</translation>
        </message>
        <message>
            <source>Push three cars over the hill, and they go through the loop</source>
            <translation>Drei Wagen über den Hügel schieben, und sie fahren durch den Looping</translation>
        </message>
        <message>
            <source>Puts a rule for USB devices and limits for real time where the system looks for them, after an administrator's consent</source>
            <translation>Legt eine Regel für USB-Geräte und Grenzen für Echtzeit dort ab, wo das System sie sucht, mit Zustimmung eines Administrators</translation>
        </message>
        <message>
            <source>Questions after each trial, one a line:
rating | How rough was it? | 7 | smooth | rough
choice | Which hand? | left | right
magnitude | How stiff was it?
text | What was it like?</source>
            <translation>Fragen nach jedem Durchgang, eine je Zeile:
rating | Wie rau war es? | 7 | glatt | rau
choice | Welche Hand? | links | rechts
magnitude | Wie steif war es?
text | Wie war es?</translation>
        </message>
        <message>
            <source>R&amp;ight</source>
            <translation>Von &amp;rechts</translation>
        </message>
        <message>
            <source>Radius</source>
            <translation>Radius</translation>
        </message>
        <message>
            <source>Radius about the device's centre within which the finger follows the hand. Beyond it a spring pulls the hand back, and the workspace goes where the hand pulls, the faster the farther.</source>
            <translation>Radius um die Mitte des Geräts, in dem der Finger der Hand folgt. Außerhalb zieht eine Feder die Hand zurück, und der Arbeitsraum geht dahin, wohin die Hand zieht, umso schneller, je weiter.</translation>
        </message>
        <message>
            <source>Radius of the cylinder or sphere on which the size of the pattern is true.</source>
            <translation>Radius des Zylinders oder der Kugel, auf denen die Größe des Musters stimmt.</translation>
        </message>
        <message>
            <source>Radius of the sphere that stands for the finger; larger than any gap it must not fall into (section 2).</source>
            <translation>Radius der Kugel, die für den Finger steht; größer als jede Lücke, in die sie nicht fallen darf (Abschnitt 2).</translation>
        </message>
        <message>
            <source>Random in each repetition</source>
            <translation>Zufällig in jeder Wiederholung</translation>
        </message>
        <message>
            <source>Rate</source>
            <translation>Rate</translation>
        </message>
        <message>
            <source>Rate control beyond the shell</source>
            <translation>Geschwindigkeitssteuerung</translation>
        </message>
        <message>
            <source>Rates</source>
            <translation>Raten</translation>
        </message>
        <message>
            <source>Ratio</source>
            <translation>Anteil</translation>
        </message>
        <message>
            <source>Ratio of tangential to normal force while the contact slides; never above static friction (section 4.2, equation 21).</source>
            <translation>Verhältnis von Tangential- zu Normalkraft, während der Kontakt gleitet; nie über der Haftreibung (Abschnitt 4.2, Gleichung 21).</translation>
        </message>
        <message>
            <source>Re&amp;move</source>
            <translation>&amp;Entfernen</translation>
        </message>
        <message>
            <source>Re&amp;move the condition</source>
            <translation>Bedingung en&amp;tfernen</translation>
        </message>
        <message>
            <source>Re&amp;name</source>
            <translation>&amp;Umbenennen</translation>
        </message>
        <message>
            <source>Re-c&amp;entre the workspace</source>
            <translation>Arbeitsraum neu &amp;zentrieren</translation>
        </message>
        <message>
            <source>Re-centre</source>
            <translation>Neu zentrieren</translation>
        </message>
        <message>
            <source>Reach</source>
            <translation>Reichweite</translation>
        </message>
        <message>
            <source>Reach of the hand</source>
            <translation>Reichweite der Hand</translation>
        </message>
        <message>
            <source>Reading the picture</source>
            <translation>Bild wird gelesen</translation>
        </message>
        <message>
            <source>Readings and forces a second, and how many there should be</source>
            <translation>Messwerte und Kräfte je Sekunde, und wie viele es sein sollten</translation>
        </message>
        <message>
            <source>Real-time priority and locked memory were granted.</source>
            <translation>Echtzeitpriorität und gesperrter Speicher wurden gewährt.</translation>
        </message>
        <message>
            <source>Recent</source>
            <translation>Zuletzt</translation>
        </message>
        <message>
            <source>Record a stroke</source>
            <translation>Strich aufnehmen</translation>
        </message>
        <message>
            <source>Record a stroke, mark the scene as A, and edit it: the same stroke is felt in both.</source>
            <translation>Einen Strich aufnehmen, die Szene als A markieren und bearbeiten: Derselbe Strich wird in beiden gefühlt.</translation>
        </message>
        <message>
            <source>Record the view</source>
            <translation>Ansicht aufnehmen</translation>
        </message>
        <message>
            <source>Recorded hand</source>
            <translation>Aufgenommene Hand</translation>
        </message>
        <message>
            <source>Recording of several hands; plots, trail and status are those of %1</source>
            <translation>Aufnahme mehrerer Hände; Diagramme, Spur und Status sind die von %1</translation>
        </message>
        <message>
            <source>Recording: finger, proxy and forces are those of then</source>
            <translation>Aufnahme: Finger, Proxy und Kräfte sind die von damals</translation>
        </message>
        <message>
            <source>Recordings</source>
            <translation>Aufnahmen</translation>
        </message>
        <message>
            <source>Recover</source>
            <translation>Wiederherstellen</translation>
        </message>
        <message>
            <source>Recover %1</source>
            <translation>%1 wiederherstellen</translation>
        </message>
        <message>
            <source>Recovering</source>
            <translation>Wird wiederhergestellt</translation>
        </message>
        <message>
            <source>Reference value</source>
            <translation>Referenzwert</translation>
        </message>
        <message>
            <source>Remember what the finger does until it is chosen again</source>
            <translation>Merken, was der Finger tut, bis der Befehl erneut gewählt wird</translation>
        </message>
        <message>
            <source>Remembers what the finger does from now on, until it is pressed again</source>
            <translation>Merkt sich ab jetzt, was der Finger tut, bis erneut gedrückt wird</translation>
        </message>
        <message>
            <source>Remove</source>
            <translation>Entfernen</translation>
        </message>
        <message>
            <source>Remove %1</source>
            <translation>%1 entfernen</translation>
        </message>
        <message>
            <source>Remove %1 from the list</source>
            <translation>%1 aus der Liste entfernen</translation>
        </message>
        <message>
            <source>Remove from the list; the file stays</source>
            <translation>Aus der Liste entfernen; die Datei bleibt</translation>
        </message>
        <message>
            <source>Remove hand %1</source>
            <translation>Hand %1 entfernen</translation>
        </message>
        <message>
            <source>Remove layer %1</source>
            <translation>Ebene %1 entfernen</translation>
        </message>
        <message>
            <source>Remove the camera</source>
            <translation>Kamera entfernen</translation>
        </message>
        <message>
            <source>Remove the set</source>
            <translation>Den Satz entfernen</translation>
        </message>
        <message>
            <source>Remove the set %1</source>
            <translation>Den Satz %1 entfernen</translation>
        </message>
        <message>
            <source>Remove the view %1</source>
            <translation>Ansicht %1 entfernen</translation>
        </message>
        <message>
            <source>Remove triangles that repeat another one of the same surface and front.</source>
            <translation>Dreiecke entfernen, die ein anderes derselben Oberfläche und Vorderseite wiederholen.</translation>
        </message>
        <message>
            <source>Rename layer %1 to %2</source>
            <translation>Ebene %1 in %2 umbenennen</translation>
        </message>
        <message>
            <source>Rename the camera</source>
            <translation>Kamera umbenennen</translation>
        </message>
        <message>
            <source>Rename the set</source>
            <translation>Den Satz umbenennen</translation>
        </message>
        <message>
            <source>Rename to %1</source>
            <translation>In %1 umbenennen</translation>
        </message>
        <message>
            <source>Render above the ceiling
at my own risk</source>
            <translation>Auf eigenes Risiko über
der Grenze rendern</translation>
        </message>
        <message>
            <source>Rendered now</source>
            <translation>Jetzt gerendert</translation>
        </message>
        <message>
            <source>Repair %1</source>
            <translation>%1 reparieren</translation>
        </message>
        <message>
            <source>Repairing the mesh</source>
            <translation>Netz wird repariert</translation>
        </message>
        <message>
            <source>Repetitions</source>
            <translation>Wiederholungen</translation>
        </message>
        <message>
            <source>Repla&amp;ce the condition</source>
            <translation>Bedingung &amp;ersetzen</translation>
        </message>
        <message>
            <source>Replace</source>
            <translation>Ersetzen</translation>
        </message>
        <message>
            <source>Replace by the selection</source>
            <translation>Durch die Auswahl ersetzen</translation>
        </message>
        <message>
            <source>Replace by this view</source>
            <translation>Durch diese Ansicht ersetzen</translation>
        </message>
        <message>
            <source>Replace the file</source>
            <translation>Datei ersetzen</translation>
        </message>
        <message>
            <source>Replace the view %1</source>
            <translation>Ansicht %1 ersetzen</translation>
        </message>
        <message>
            <source>Reset %1</source>
            <translation>%1 zurücksetzen</translation>
        </message>
        <message>
            <source>Rests at</source>
            <translation>Ruht bei</translation>
        </message>
        <message>
            <source>Right</source>
            <translation>Rechts</translation>
        </message>
        <message>
            <source>Right answers to go down</source>
            <translation>Richtige Antworten für abwärts</translation>
        </message>
        <message>
            <source>Right button</source>
            <translation>Rechte Taste</translation>
        </message>
        <message>
            <source>Right turns, middle moves</source>
            <translation>Rechts dreht, Mitte verschiebt</translation>
        </message>
        <message>
            <source>Rotation</source>
            <translation>Drehung</translation>
        </message>
        <message>
            <source>Rubber</source>
            <translation>Gummi</translation>
        </message>
        <message>
            <source>Rubber on dry concrete</source>
            <translation>Gummi auf trockenem Beton</translation>
        </message>
        <message>
            <source>Rubber on wet concrete</source>
            <translation>Gummi auf nassem Beton</translation>
        </message>
        <message>
            <source>Run the study</source>
            <translation>Studie durchführen</translation>
        </message>
        <message>
            <source>Run this line in a terminal, then plug the device in anew:</source>
            <translation>Diese Zeile in einem Terminal ausführen, dann das Gerät neu anschließen:</translation>
        </message>
        <message>
            <source>Run...</source>
            <translation>Durchführen...</translation>
        </message>
        <message>
            <source>S&amp;et</source>
            <translation>&amp;Setzen</translation>
        </message>
        <message>
            <source>S&amp;how the condition</source>
            <translation>Bedingung &amp;zeigen</translation>
        </message>
        <message>
            <source>S&amp;hrink</source>
            <translation>Ver&amp;kleinern</translation>
        </message>
        <message>
            <source>S&amp;mooth</source>
            <translation>&amp;Glätten</translation>
        </message>
        <message>
            <source>S&amp;plit off</source>
            <translation>A&amp;btrennen</translation>
        </message>
        <message>
            <source>S&amp;tanding still</source>
            <translation>S&amp;tillstehend</translation>
        </message>
        <message>
            <source>S&amp;tatic friction</source>
            <translation>&amp;Haftreibung</translation>
        </message>
        <message>
            <source>S&amp;tiffness</source>
            <translation>&amp;Steifigkeit</translation>
        </message>
        <message>
            <source>STOP</source>
            <translation>STOPP</translation>
        </message>
        <message>
            <source>STOP: hold Esc</source>
            <translation>STOPP: Esc halten</translation>
        </message>
        <message>
            <source>Sa&amp;ve as preset...</source>
            <translation>Als V&amp;orgabe speichern...</translation>
        </message>
        <message>
            <source>Said before</source>
            <translation>Bisher gesagt</translation>
        </message>
        <message>
            <source>Sam&amp;e colour</source>
            <translation>Gleiche &amp;Farbe</translation>
        </message>
        <message>
            <source>Same as the active &amp;one</source>
            <translation>&amp;Wie die aktive</translation>
        </message>
        <message>
            <source>Same colour</source>
            <translation>Gleiche Farbe</translation>
        </message>
        <message>
            <source>Same feel</source>
            <translation>Gleiche Haptik</translation>
        </message>
        <message>
            <source>Same feel as %1</source>
            <translation>Gleiche Haptik wie %1</translation>
        </message>
        <message>
            <source>Samples</source>
            <translation>Beispiele</translation>
        </message>
        <message>
            <source>Samples: moving worlds</source>
            <translation>Beispiele: bewegte Welten</translation>
        </message>
        <message>
            <source>Samples: surfaces</source>
            <translation>Beispiele: Oberflächen</translation>
        </message>
        <message>
            <source>Save &amp;as...</source>
            <translation>Speichern &amp;unter...</translation>
        </message>
        <message>
            <source>Save &amp;picture...</source>
            <translation>Bil&amp;d speichern...</translation>
        </message>
        <message>
            <source>Save &amp;recording of the last minute...</source>
            <translation>Aufnahme der letzten &amp;Minute speichern...</translation>
        </message>
        <message>
            <source>Save As...</source>
            <translation>Speichern unter...</translation>
        </message>
        <message>
            <source>Save as preset</source>
            <translation>Als Vorgabe speichern</translation>
        </message>
        <message>
            <source>Save as...</source>
            <translation>Speichern unter...</translation>
        </message>
        <message>
            <source>Save it to keep it; its file has not been touched.</source>
            <translation>Speichern, um sie zu behalten; ihre Datei wurde nicht angerührt.</translation>
        </message>
        <message>
            <source>Save the changes to %1 before %2?</source>
            <translation>Änderungen an %1 vor %2 speichern?</translation>
        </message>
        <message>
            <source>Save the last minute</source>
            <translation>Die letzte Minute speichern</translation>
        </message>
        <message>
            <source>Save the scene</source>
            <translation>Szene speichern</translation>
        </message>
        <message>
            <source>Save the self-test into a folder</source>
            <translation>Den Selbsttest in einem Ordner speichern</translation>
        </message>
        <message>
            <source>Save the study</source>
            <translation>Studie speichern</translation>
        </message>
        <message>
            <source>Save the view</source>
            <translation>Ansicht speichern</translation>
        </message>
        <message>
            <source>Save your work and start the program again.</source>
            <translation>Die Arbeit speichern und das Programm neu starten.</translation>
        </message>
        <message>
            <source>Saved on demand</source>
            <translation>Auf Verlangen gespeichert</translation>
        </message>
        <message>
            <source>Saving</source>
            <translation>Speichern</translation>
        </message>
        <message>
            <source>Saving writes this scene over it; what it holds now is kept beside it as the first backup.</source>
            <translation>Speichern überschreibt sie mit dieser Szene; was sie jetzt enthält, bleibt daneben als erste Sicherung erhalten.</translation>
        </message>
        <message>
            <source>Scale</source>
            <translation>Maßstab</translation>
        </message>
        <message>
            <source>Scale %1</source>
            <translation>%1 skalieren</translation>
        </message>
        <message>
            <source>Scale the scene</source>
            <translation>Szene skalieren</translation>
        </message>
        <message>
            <source>Scale the scene by %1.</source>
            <translation>Szene mit %1 skalieren.</translation>
        </message>
        <message>
            <source>Scale to fit the hand</source>
            <translation>Passend zur Hand skalieren</translation>
        </message>
        <message>
            <source>Scene</source>
            <translation>Szene</translation>
        </message>
        <message>
            <source>Scene of %1</source>
            <translation>Szene von %1</translation>
        </message>
        <message>
            <source>Scenes</source>
            <translation>Szenen</translation>
        </message>
        <message>
            <source>Scenes that were not saved</source>
            <translation>Nicht gespeicherte Szenen</translation>
        </message>
        <message>
            <source>Se&amp;lf-test...</source>
            <translation>Se&amp;lbsttest...</translation>
        </message>
        <message>
            <source>Search for a command</source>
            <translation>Befehl suchen</translation>
        </message>
        <message>
            <source>Search for a command   %1</source>
            <translation>Befehl suchen   %1</translation>
        </message>
        <message>
            <source>Search in the scene</source>
            <translation>In der Szene suchen</translation>
        </message>
        <message>
            <source>Search keys and what they do</source>
            <translation>Tasten und ihre Wirkung suchen</translation>
        </message>
        <message>
            <source>Search presets</source>
            <translation>Vorgaben suchen</translation>
        </message>
        <message>
            <source>Search presets by name, tag or source</source>
            <translation>Vorgaben nach Name, Schlagwort oder Quelle suchen</translation>
        </message>
        <message>
            <source>Search the guide</source>
            <translation>Handbuch durchsuchen</translation>
        </message>
        <message>
            <source>Search the scene</source>
            <translation>Szene durchsuchen</translation>
        </message>
        <message>
            <source>Seconds of the moving world for each of the hand's: small for what swings faster than a hand feels.</source>
            <translation>Sekunden der bewegten Welt für jede der Hand: klein für das, was schneller schwingt, als eine Hand fühlt.</translation>
        </message>
        <message>
            <source>See and set how it feels</source>
            <translation>Sehen und festlegen, wie sie sich anfühlt</translation>
        </message>
        <message>
            <source>Seed</source>
            <translation>Startwert</translation>
        </message>
        <message>
            <source>Seen, but not felt.</source>
            <translation>Sichtbar, aber nicht fühlbar.</translation>
        </message>
        <message>
            <source>Select</source>
            <translation>Auswahl</translation>
        </message>
        <message>
            <source>Select a surface first, or drop the picture on the model.</source>
            <translation>Zuerst eine Oberfläche auswählen oder das Bild auf dem Modell ablegen.</translation>
        </message>
        <message>
            <source>Select a surface first.</source>
            <translation>Wählen Sie zuerst eine Fläche.</translation>
        </message>
        <message>
            <source>Select an object to give it a mass, a hinge or a slider.</source>
            <translation>Ein Objekt auswählen, um ihm eine Masse, ein Scharnier oder eine Schiene zu geben.</translation>
        </message>
        <message>
            <source>Select an object to move, turn and scale it: here, or with the tool Move (M).</source>
            <translation>Ein Objekt auswählen, um es zu verschieben, zu drehen und zu skalieren: hier oder mit dem Werkzeug Verschieben (M).</translation>
        </message>
        <message>
            <source>Select set %1</source>
            <translation>Satz %1 auswählen</translation>
        </message>
        <message>
            <source>Select surface %1</source>
            <translation>Oberfläche %1 auswählen</translation>
        </message>
        <message>
            <source>Select the &amp;whole group</source>
            <translation>Ganze Gruppe aus&amp;wählen</translation>
        </message>
        <message>
            <source>Select the objects that are to be a group first.</source>
            <translation>Zuerst die Objekte auswählen, die eine Gruppe sein sollen.</translation>
        </message>
        <message>
            <source>Select the surfaces that are to feel like %1, or drag it onto one.</source>
            <translation>Die Oberflächen auswählen, die sich wie %1 anfühlen sollen, oder es auf eine ziehen.</translation>
        </message>
        <message>
            <source>Select three or more objects that move on their own.</source>
            <translation>Drei oder mehr Objekte auswählen, die sich einzeln bewegen.</translation>
        </message>
        <message>
            <source>Select two or more objects; they are aligned with the one selected last.</source>
            <translation>Zwei oder mehr Objekte auswählen; sie werden am zuletzt ausgewählten ausgerichtet.</translation>
        </message>
        <message>
            <source>Select two or more surfaces of one object that are not locked, and merge them then.</source>
            <translation>Zwei oder mehr nicht gesperrte Oberflächen eines Objekts auswählen und sie dann vereinigen.</translation>
        </message>
        <message>
            <source>Select what is to be kept first: surfaces, or triangles (Q).</source>
            <translation>Erst auswählen, was behalten werden soll: Oberflächen oder Dreiecke (Q).</translation>
        </message>
        <message>
            <source>Select: click a surface to see and set how it feels</source>
            <translation>Auswählen: eine Oberfläche anklicken, um zu sehen und festzulegen, wie sie sich anfühlt</translation>
        </message>
        <message>
            <source>Selected objects turn and scale about the middle of the one selected last</source>
            <translation>Gewählte Objekte drehen und skalieren sich um die Mitte des zuletzt gewählten</translation>
        </message>
        <message>
            <source>Selected objects turn and scale about the middle of them all</source>
            <translation>Gewählte Objekte drehen und skalieren sich um ihrer aller Mitte</translation>
        </message>
        <message>
            <source>Selected objects turn and scale about the origin of the world</source>
            <translation>Gewählte Objekte drehen und skalieren sich um den Ursprung der Welt</translation>
        </message>
        <message>
            <source>Selections that are kept under names, with the scene</source>
            <translation>Auswahlen, die unter Namen mit der Szene behalten werden</translation>
        </message>
        <message>
            <source>Self-test of %1</source>
            <translation>Selbsttest von %1</translation>
        </message>
        <message>
            <source>Send mine</source>
            <translation>Meine senden</translation>
        </message>
        <message>
            <source>Servo</source>
            <translation>Servo</translation>
        </message>
        <message>
            <source>Servo loop: ticks a second, and the largest deviation of a period over the last half second</source>
            <translation>Servoschleife: Takte je Sekunde und die größte Abweichung einer Periode in der letzten halben Sekunde</translation>
        </message>
        <message>
            <source>Set</source>
            <translation>Setzen</translation>
        </message>
        <message>
            <source>Set %1</source>
            <translation>Satz %1</translation>
        </message>
        <message>
            <source>Set by hand: no source</source>
            <translation>Von Hand gesetzt: keine Quelle</translation>
        </message>
        <message>
            <source>Set the a&amp;xes by moving</source>
            <translation>Achsen durch &amp;Bewegen festlegen</translation>
        </message>
        <message>
            <source>Set the axes by moving</source>
            <translation>Achsen durch Bewegen festlegen</translation>
        </message>
        <message>
            <source>Sets</source>
            <translation>Sätze</translation>
        </message>
        <message>
            <source>Sets b&amp;y name</source>
            <translation>&amp;Vorhandene Sätze</translation>
        </message>
        <message>
            <source>Shaking along %1.</source>
            <translation>Es rüttelt entlang %1.</translation>
        </message>
        <message>
            <source>Shapes that another program has changed, with the feel that this scene has</source>
            <translation>Formen, die ein anderes Programm geändert hat, mit der Haptik, die diese Szene hat</translation>
        </message>
        <message>
            <source>Shell</source>
            <translation>Schale</translation>
        </message>
        <message>
            <source>Shoe on ice</source>
            <translation>Schuh auf Eis</translation>
        </message>
        <message>
            <source>Shoe on wood</source>
            <translation>Schuh auf Holz</translation>
        </message>
        <message>
            <source>Show</source>
            <translation>Zeigen</translation>
        </message>
        <message>
            <source>Show %1</source>
            <translation>%1 einblenden</translation>
        </message>
        <message>
            <source>Show %1 alone</source>
            <translation>%1 allein zeigen</translation>
        </message>
        <message>
            <source>Show &amp;alone</source>
            <translation>A&amp;llein zeigen</translation>
        </message>
        <message>
            <source>Show &amp;report</source>
            <translation>Be&amp;richt zeigen</translation>
        </message>
        <message>
            <source>Show (Alt+H shows all)</source>
            <translation>Einblenden (Alt+H blendet alle ein)</translation>
        </message>
        <message>
            <source>Show all</source>
            <translation>Alle einblenden</translation>
        </message>
        <message>
            <source>Show every object and every surface</source>
            <translation>Jedes Objekt und jede Oberfläche einblenden</translation>
        </message>
        <message>
            <source>Show finger, proxy, force and contacts</source>
            <translation>Finger, Proxy, Kraft und Kontakte zeigen</translation>
        </message>
        <message>
            <source>Show or &amp;hide layer</source>
            <translation>Ebene ein- oder &amp;ausblenden</translation>
        </message>
        <message>
            <source>Show state %1</source>
            <translation>Zustand %1 zeigen</translation>
        </message>
        <message>
            <source>Show the panel and give it the keys</source>
            <translation>Den Bereich zeigen und ihm die Tastatur geben</translation>
        </message>
        <message>
            <source>Show the plot: %1</source>
            <translation>Das Diagramm zeigen: %1</translation>
        </message>
        <message>
            <source>Show the status, health, plots and trail of this hand</source>
            <translation>Status, Zustand, Diagramme und Spur dieser Hand zeigen</translation>
        </message>
        <message>
            <source>Show the whole scene</source>
            <translation>Ganze Szene zeigen</translation>
        </message>
        <message>
            <source>Shown, the finger on the surface</source>
            <translation>Gezeigt, der Finger auf der Oberfläche</translation>
        </message>
        <message>
            <source>Shows or hides this strip; the wheel over it changes the span of time</source>
            <translation>Zeigt oder verbirgt diesen Streifen; das Mausrad darüber ändert die Zeitspanne</translation>
        </message>
        <message>
            <source>Similar normals</source>
            <translation>Ähnliche Normalen</translation>
        </message>
        <message>
            <source>Simulated hand</source>
            <translation>Simulierte Hand</translation>
        </message>
        <message>
            <source>Simulated hand · forces off</source>
            <translation>Simulierte Hand · Kräfte aus</translation>
        </message>
        <message>
            <source>Six plates from smooth to rough: where the finger sticks and breaks loose</source>
            <translation>Sechs Platten von glatt bis stumpf: wo der Finger haftet und losbricht</translation>
        </message>
        <message>
            <source>Six plates from soft to hard, up to what the device can give</source>
            <translation>Sechs Platten von weich bis hart, bis zu dem, was das Gerät hergibt</translation>
        </message>
        <message>
            <source>Six plates like honey: the faster, the harder to slide</source>
            <translation>Sechs Platten wie Honig: je schneller, desto schwerer zu gleiten</translation>
        </message>
        <message>
            <source>Size</source>
            <translation>Größe</translation>
        </message>
        <message>
            <source>Size of everything</source>
            <translation>Größe von allem</translation>
        </message>
        <message>
            <source>Ski on wet snow</source>
            <translation>Ski auf nassem Schnee</translation>
        </message>
        <message>
            <source>Slider</source>
            <translation>Schiene</translation>
        </message>
        <message>
            <source>Sliding</source>
            <translation>Gleiten</translation>
        </message>
        <message>
            <source>Smaller brus&amp;h</source>
            <translation>&amp;Kleinerer Pinsel</translation>
        </message>
        <message>
            <source>Smallest difference</source>
            <translation>Kleinster Unterschied</translation>
        </message>
        <message>
            <source>Smooth</source>
            <translation>Glätten</translation>
        </message>
        <message>
            <source>Smooth normals of %1</source>
            <translation>Glatte Normalen von %1</translation>
        </message>
        <message>
            <source>Smooth part</source>
            <translation>Glatter Teil</translation>
        </message>
        <message>
            <source>Soft as foam</source>
            <translation>Weich wie Schaumstoff</translation>
        </message>
        <message>
            <source>Soft as gel</source>
            <translation>Weich wie Gel</translation>
        </message>
        <message>
            <source>Softness</source>
            <translation>Weichheit</translation>
        </message>
        <message>
            <source>Somebody</source>
            <translation>Jemand</translation>
        </message>
        <message>
            <source>Source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <source>Space, Enter</source>
            <translation>Leertaste, Eingabe</translation>
        </message>
        <message>
            <source>Space, Left, Right, Up, Down</source>
            <translation>Leertaste, Links, Rechts, Auf, Ab</translation>
        </message>
        <message>
            <source>Space, S, F2</source>
            <translation>Leertaste, S, F2</translation>
        </message>
        <message>
            <source>Speed of the playback</source>
            <translation>Geschwindigkeit der Wiedergabe</translation>
        </message>
        <message>
            <source>Sphere</source>
            <translation>Kugel</translation>
        </message>
        <message>
            <source>Spheres at level %1 of %2: %3 (+ and -)</source>
            <translation>Kugeln auf Stufe %1 von %2: %3 (+ und -)</translation>
        </message>
        <message>
            <source>Spheres: being read</source>
            <translation>Kugeln: werden gelesen</translation>
        </message>
        <message>
            <source>Spherical</source>
            <translation>Kugelförmig</translation>
        </message>
        <message numerus="yes">
            <source>Split off %n triangle(s)</source>
            <translation>
                <numerusform>%n Dreieck abtrennen</numerusform>
                <numerusform>%n Dreiecke abtrennen</numerusform>
            </translation>
        </message>
        <message>
            <source>Spring</source>
            <translation>Feder</translation>
        </message>
        <message>
            <source>St&amp;ronger brush</source>
            <translation>&amp;Stärkerer Pinsel</translation>
        </message>
        <message>
            <source>Staircase</source>
            <translation>Treppe (Staircase-Verfahren)</translation>
        </message>
        <message>
            <source>Staircase over a parameter</source>
            <translation>Treppe über einen Parameter</translation>
        </message>
        <message>
            <source>Staircase, %1 down 1 up, over %2</source>
            <translation>Treppe, %1 abwärts 1 aufwärts, über %2</translation>
        </message>
        <message>
            <source>State %1</source>
            <translation>Zustand %1</translation>
        </message>
        <message>
            <source>Static friction</source>
            <translation>Haftreibung</translation>
        </message>
        <message>
            <source>Status, health, plots and trail are those of the chosen hand.</source>
            <translation>Status, Zustand, Diagramme und Spur sind die der gewählten Hand.</translation>
        </message>
        <message>
            <source>Status, health, plots and trail are those of the next hand; of a recording's hands while one is shown</source>
            <translation>Status, Zustand, Diagramme und Spur sind die der nächsten Hand; solange eine Aufnahme gezeigt wird, die einer ihrer Hände</translation>
        </message>
        <message>
            <source>Steel on ice</source>
            <translation>Stahl auf Eis</translation>
        </message>
        <message>
            <source>Steel on steel, dry</source>
            <translation>Stahl auf Stahl, trocken</translation>
        </message>
        <message>
            <source>Steel on steel, oiled</source>
            <translation>Stahl auf Stahl, geölt</translation>
        </message>
        <message>
            <source>Steps multiply and divide</source>
            <translation>Schritte multiplizieren und dividieren</translation>
        </message>
        <message>
            <source>Steps, the next after each reversal</source>
            <translation>Schritte, der nächste nach jeder Umkehr</translation>
        </message>
        <message>
            <source>Stiffest</source>
            <translation>Am steifsten</translation>
        </message>
        <message>
            <source>Stiffness</source>
            <translation>Steifigkeit</translation>
        </message>
        <message>
            <source>Stiffness, damping, friction and viscosity</source>
            <translation>Steifigkeit, Dämpfung, Reibung und Viskosität</translation>
        </message>
        <message>
            <source>Still</source>
            <translation>Still</translation>
        </message>
        <message>
            <source>Stimuli may be felt again before the choice</source>
            <translation>Reize dürfen vor der Wahl noch einmal gefühlt werden</translation>
        </message>
        <message>
            <source>Stimulus</source>
            <translation>Reiz</translation>
        </message>
        <message>
            <source>Stimulus %1 of %2</source>
            <translation>Reiz %1 von %2</translation>
        </message>
        <message>
            <source>Stimulus lasts</source>
            <translation>Reiz dauert</translation>
        </message>
        <message>
            <source>Stop it at the start</source>
            <translation>Am Anfang anhalten</translation>
        </message>
        <message>
            <source>Stop, and go on by one step of the haptics</source>
            <translation>Anhalten und um einen Schritt der Haptik weitergehen</translation>
        </message>
        <message>
            <source>Stopped by the button of the device. Device &gt; Forces on goes on.</source>
            <translation>Durch die Taste des Geräts gestoppt. Weiter mit Gerät &gt; Kräfte an.</translation>
        </message>
        <message>
            <source>Stopped: the device gets no force. Device &gt; Forces on goes on.</source>
            <translation>Gestoppt: Das Gerät erhält keine Kraft. Weiter mit Gerät &gt; Kräfte an.</translation>
        </message>
        <message>
            <source>Strength</source>
            <translation>Stärke</translation>
        </message>
        <message>
            <source>Strength of the vibration</source>
            <translation>Stärke der Vibration</translation>
        </message>
        <message>
            <source>Stroke the model with the finger (W, then drag): what the layers are along the way appears here.</source>
            <translation>Mit dem Finger über das Modell streichen (W, dann ziehen): Was die Ebenen entlang des Wegs sind, erscheint hier.</translation>
        </message>
        <message>
            <source>Stroke the model, then press "Record a stroke" again.</source>
            <translation>Über das Modell streichen, dann erneut "Strich aufnehmen" drücken.</translation>
        </message>
        <message>
            <source>Studies</source>
            <translation>Studien</translation>
        </message>
        <message>
            <source>Studies (*.%1)</source>
            <translation>Studien (*.%1)</translation>
        </message>
        <message>
            <source>Studs</source>
            <translation>Noppen</translation>
        </message>
        <message>
            <source>Study</source>
            <translation>Studie</translation>
        </message>
        <message>
            <source>Subtract</source>
            <translation>Abziehen</translation>
        </message>
        <message>
            <source>Surface</source>
            <translation>Oberfläche</translation>
        </message>
        <message>
            <source>Surfaces are rendered as stiff as the author wants them. The device may shake; the guard stays on. Off again with the next start.</source>
            <translation>Oberflächen werden so steif gerendert, wie der Autor es will. Das Gerät kann zittern; der Schutz bleibt an. Beim nächsten Start wieder aus.</translation>
        </message>
        <message>
            <source>Swap A and B</source>
            <translation>A und B tauschen</translation>
        </message>
        <message>
            <source>Switch layer %1 off</source>
            <translation>Ebene %1 ausschalten</translation>
        </message>
        <message>
            <source>Switch layer %1 on</source>
            <translation>Ebene %1 einschalten</translation>
        </message>
        <message>
            <source>Switch the forces on again when you hold the handle.</source>
            <translation>Kräfte wieder einschalten, wenn Sie den Griff halten.</translation>
        </message>
        <message>
            <source>Switch the layer off: it is not felt (Space)</source>
            <translation>Ebene ausschalten: Sie wird nicht gefühlt (Leertaste)</translation>
        </message>
        <message>
            <source>Switch the layer on (Space)</source>
            <translation>Ebene einschalten (Leertaste)</translation>
        </message>
        <message>
            <source>Switch the selected layer off, or on again</source>
            <translation>Die gewählte Ebene aus- oder wieder einschalten</translation>
        </message>
        <message>
            <source>Switch them on when you hold the handle.</source>
            <translation>Sie einschalten, wenn Sie den Griff halten.</translation>
        </message>
        <message>
            <source>Ta&amp;ke the group apart</source>
            <translation>Gruppe &amp;auflösen</translation>
        </message>
        <message>
            <source>Tab in the view</source>
            <translation>Tab in der Ansicht</translation>
        </message>
        <message>
            <source>Tables</source>
            <translation>Tabellen</translation>
        </message>
        <message>
            <source>Tactum</source>
            <translation>Tactum</translation>
        </message>
        <message>
            <source>Take a group apart</source>
            <translation>Eine Gruppe auflösen</translation>
        </message>
        <message>
            <source>Take back</source>
            <translation>Zurücknehmen</translation>
        </message>
        <message>
            <source>Take its points out of the view</source>
            <translation>Seine Punkte aus der Ansicht nehmen</translation>
        </message>
        <message>
            <source>Take one unit of the file as 1 %1, now and for other files of its format</source>
            <translation>Eine Einheit der Datei als 1 %1 lesen, jetzt und bei anderen Dateien ihres Formats</translation>
        </message>
        <message>
            <source>Take the file with %1 up, now and for other files of its format</source>
            <translation>Die Datei mit %1 nach oben lesen, jetzt und bei anderen Dateien ihres Formats</translation>
        </message>
        <message>
            <source>Take the handle firmly, then arm again.</source>
            <translation>Griff fest nehmen, dann Kräfte wieder einschalten.</translation>
        </message>
        <message>
            <source>Take the handle in your hand. The forces come on when you begin.</source>
            <translation>Bitte nehmen Sie den Griff in die Hand. Die Kräfte gehen an, wenn Sie beginnen.</translation>
        </message>
        <message>
            <source>Take the last 10 s</source>
            <translation>Letzte 10 s nehmen</translation>
        </message>
        <message>
            <source>Take the last edit back</source>
            <translation>Die letzte Änderung zurücknehmen</translation>
        </message>
        <message>
            <source>Take the last point of the path away</source>
            <translation>Den letzten Punkt der Bahn entfernen</translation>
        </message>
        <message>
            <source>Take the selected layer off the surface</source>
            <translation>Die gewählte Ebene von der Oberfläche nehmen</translation>
        </message>
        <message>
            <source>Take the selected objects out of the scene, with their bodies and joints</source>
            <translation>Die gewählten Objekte aus der Szene nehmen, mit ihren Körpern und Gelenken</translation>
        </message>
        <message>
            <source>Take the workspace along at its edge</source>
            <translation>Arbeitsraum an seinem Rand mitnehmen</translation>
        </message>
        <message>
            <source>Take these triangles out without opening the mesh.</source>
            <translation>Diese Dreiecke herausnehmen, ohne das Netz zu öffnen.</translation>
        </message>
        <message>
            <source>Take this joint away</source>
            <translation>Dieses Gelenk entfernen</translation>
        </message>
        <message>
            <source>Taken as &amp;centimetres</source>
            <translation>Als Ze&amp;ntimeter lesen</translation>
        </message>
        <message>
            <source>Taken as &amp;metres</source>
            <translation>Als &amp;Meter lesen</translation>
        </message>
        <message>
            <source>Taken as i&amp;nches</source>
            <translation>Als Z&amp;oll lesen</translation>
        </message>
        <message>
            <source>Taken as m&amp;illimetres</source>
            <translation>Als M&amp;illimeter lesen</translation>
        </message>
        <message>
            <source>Target</source>
            <translation>Ziel</translation>
        </message>
        <message>
            <source>Teflon on steel</source>
            <translation>Teflon auf Stahl</translation>
        </message>
        <message>
            <source>Textures and force shading are left out: the scene is too heavy.</source>
            <translation>Texturen und Kraft-Shading sind ausgelassen: Die Szene ist zu schwer.</translation>
        </message>
        <message>
            <source>Textures are left out: the scene is too heavy.</source>
            <translation>Texturen sind ausgelassen: Die Szene ist zu schwer.</translation>
        </message>
        <message>
            <source>That was all. Thank you.</source>
            <translation>Das war alles. Vielen Dank.</translation>
        </message>
        <message>
            <source>The &amp;last one</source>
            <translation>Das &amp;letzte</translation>
        </message>
        <message>
            <source>The &amp;mask of the chosen layer</source>
            <translation>Die &amp;Maske der gewählten Ebene</translation>
        </message>
        <message>
            <source>The &amp;middle of all</source>
            <translation>Die &amp;Mitte aller</translation>
        </message>
        <message>
            <source>The &amp;origin</source>
            <translation>Der &amp;Ursprung</translation>
        </message>
        <message>
            <source>The &amp;other side</source>
            <translation>Die &amp;andere Seite</translation>
        </message>
        <message>
            <source>The answers are in %1, the touch beside them. The forces are off.</source>
            <translation>Die Antworten sind in %1, die Berührung daneben. Die Kräfte sind aus.</translation>
        </message>
        <message>
            <source>The audio output could not be opened; is another program holding it?</source>
            <translation>Der Audioausgang konnte nicht geöffnet werden; wird er von einem anderen Programm gehalten?</translation>
        </message>
        <message>
            <source>The bounding spheres of one level of the collision hierarchy</source>
            <translation>Die Hüllkugeln einer Stufe der Kollisionshierarchie</translation>
        </message>
        <message>
            <source>The brush</source>
            <translation>Der Pinsel</translation>
        </message>
        <message>
            <source>The brush d&amp;oes</source>
            <translation>P&amp;inselmodus</translation>
        </message>
        <message>
            <source>The brush p&amp;aints</source>
            <translation>Der &amp;Pinsel malt</translation>
        </message>
        <message>
            <source>The bundle was written to %1.</source>
            <translation>Das Bündel wurde nach %1 geschrieben.</translation>
        </message>
        <message>
            <source>The button that must be held is not.</source>
            <translation>Die Taste, die gehalten werden muss, wird nicht gehalten.</translation>
        </message>
        <message>
            <source>The buttons</source>
            <translation>Die Tasten</translation>
        </message>
        <message>
            <source>The camera goes to a view</source>
            <translation>Kamera zu einer Ansicht</translation>
        </message>
        <message>
            <source>The camera looks from here from now on</source>
            <translation>Die Kamera blickt von jetzt an von hier</translation>
        </message>
        <message>
            <source>The camera that is kept under this name</source>
            <translation>Die Kamera, die unter diesem Namen gespeichert ist</translation>
        </message>
        <message>
            <source>The camera under another name</source>
            <translation>Die Kamera unter einem anderen Namen</translation>
        </message>
        <message>
            <source>The children of the spheres shown</source>
            <translation>Die Kinder der gezeigten Kugeln</translation>
        </message>
        <message>
            <source>The chosen &amp;layer</source>
            <translation>Die gewählte &amp;Ebene</translation>
        </message>
        <message>
            <source>The chosen condition becomes the scene as it is now</source>
            <translation>Die gewählte Bedingung wird zur Szene, wie sie jetzt ist</translation>
        </message>
        <message>
            <source>The chosen condition is no part of the study any more</source>
            <translation>Die gewählte Bedingung gehört nicht mehr zur Studie</translation>
        </message>
        <message>
            <source>The chosen preset as a file for others</source>
            <translation>Die gewählte Vorgabe als Datei für andere</translation>
        </message>
        <message>
            <source>The clutch is held: the handle moves, the finger stays.</source>
            <translation>Die Kupplung ist gehalten: Der Griff bewegt sich, der Finger bleibt.</translation>
        </message>
        <message>
            <source>The condition that is chosen in the dock Study becomes the scene as it is now</source>
            <translation>Die im Bereich Studie gewählte Bedingung wird zur Szene, wie sie jetzt ist</translation>
        </message>
        <message>
            <source>The connection to %1 was lost, and is there again. The forces are off.</source>
            <translation>Die Verbindung zu %1 war verloren und ist wieder da. Die Kräfte sind aus.</translation>
        </message>
        <message>
            <source>The constraint planes of the proxy as discs, their rims yellow while they stick, violet while they slip</source>
            <translation>Die Zwangsebenen des Proxys als Scheiben, ihr Rand gelb, wenn sie haften, violett, wenn sie gleiten</translation>
        </message>
        <message>
            <source>The cursor</source>
            <translation>Mauszeiger</translation>
        </message>
        <message>
            <source>The device at rest</source>
            <translation>Das Gerät in Ruhe</translation>
        </message>
        <message>
            <source>The device does not answer. Look at its cable and its power.</source>
            <translation>Das Gerät antwortet nicht. Kabel und Stromversorgung prüfen.</translation>
        </message>
        <message>
            <source>The device does not push along %1: look at the supply of its motors, and whether something holds it.</source>
            <translation>Das Gerät drückt nicht entlang %1: die Stromversorgung seiner Motoren prüfen, und ob etwas es festhält.</translation>
        </message>
        <message>
            <source>The device gets its full force.</source>
            <translation>Das Gerät erhält seine volle Kraft.</translation>
        </message>
        <message>
            <source>The device gets no force.</source>
            <translation>Das Gerät erhält keine Kraft.</translation>
        </message>
        <message>
            <source>The device gets no force. Also: hold Esc for half a second.</source>
            <translation>Das Gerät erhält keine Kraft. Auch: Esc eine halbe Sekunde halten.</translation>
        </message>
        <message>
            <source>The device is at the haptic server, and is chosen there.</source>
            <translation>Das Gerät ist am haptischen Server und wird dort gewählt.</translation>
        </message>
        <message>
            <source>The device is being made ready</source>
            <translation>Das Gerät wird bereit gemacht</translation>
        </message>
        <message>
            <source>The device is held after a fault; arm it once more first.</source>
            <translation>Das Gerät steht nach einem Fehler still; zuerst die Kräfte noch einmal einschalten.</translation>
        </message>
        <message>
            <source>The device is the server's; measure it there.</source>
            <translation>Das Gerät gehört dem Server; dort vermessen.</translation>
        </message>
        <message>
            <source>The device sent nothing, or readings that cannot be true.</source>
            <translation>Das Gerät sandte nichts oder Messwerte, die nicht wahr sein können.</translation>
        </message>
        <message>
            <source>The device shook against a surface. The stiffness was halved, and comes back within seconds. Hold the handle more firmly, or lower the stiffness.</source>
            <translation>Das Gerät zitterte an einer Oberfläche. Die Steifigkeit wurde halbiert und kommt binnen Sekunden zurück. Den Griff fester halten oder die Steifigkeit senken.</translation>
        </message>
        <message>
            <source>The device, and whether it may push</source>
            <translation>Das Gerät, und ob es drücken darf</translation>
        </message>
        <message>
            <source>The feel of %1 is copied; Ctrl+V gives it to the selected surfaces.</source>
            <translation>Die Haptik von %1 ist kopiert; Strg+V gibt sie den gewählten Oberflächen.</translation>
        </message>
        <message>
            <source>The figures are laid over the device's profile, and hold from now on</source>
            <translation>Die Größen werden über das Profil des Geräts gelegt und gelten von nun an</translation>
        </message>
        <message>
            <source>The file says it, or it could lose edits; see the bar over the view after opening.</source>
            <translation>Die Datei gibt es an, oder Änderungen könnten verloren gehen; siehe die Leiste über der Ansicht nach dem Öffnen.</translation>
        </message>
        <message>
            <source>The finger was faster than a hand that holds it.</source>
            <translation>Der Finger war schneller als eine Hand, die ihn hält.</translation>
        </message>
        <message>
            <source>The first hand is chosen, which always is there; Disconnect gives its device back.</source>
            <translation>Gewählt ist die erste Hand, die es immer gibt; Trennen gibt ihr Gerät zurück.</translation>
        </message>
        <message>
            <source>The force comes back.</source>
            <translation>Die Kraft kommt zurück.</translation>
        </message>
        <message>
            <source>The force is about to begin.</source>
            <translation>Die Kraft beginnt gleich.</translation>
        </message>
        <message>
            <source>The force on the handle, and the most that this device may give</source>
            <translation>Die Kraft auf den Griff und die größte, die dieses Gerät geben darf</translation>
        </message>
        <message>
            <source>The force was taken away.</source>
            <translation>Die Kraft wurde weggenommen.</translation>
        </message>
        <message>
            <source>The force would have jumped by more than a surface can push.</source>
            <translation>Die Kraft wäre um mehr gesprungen, als eine Oberfläche drücken kann.</translation>
        </message>
        <message>
            <source>The forces are off already.</source>
            <translation>Die Kräfte sind schon aus.</translation>
        </message>
        <message>
            <source>The forces are off.</source>
            <translation>Die Kräfte sind aus.</translation>
        </message>
        <message>
            <source>The forces are off. Hold the handle, then arm.</source>
            <translation>Die Kräfte sind aus. Griff halten, dann Kräfte einschalten.</translation>
        </message>
        <message>
            <source>The forces are off. Take the handle in your hand.</source>
            <translation>Die Kräfte sind aus. Bitte nehmen Sie den Griff in die Hand.</translation>
        </message>
        <message>
            <source>The forces are off. The device is being closed.</source>
            <translation>Die Kräfte sind aus. Das Gerät wird geschlossen.</translation>
        </message>
        <message>
            <source>The forces are on.</source>
            <translation>Die Kräfte sind an.</translation>
        </message>
        <message>
            <source>The forces are on; switch them off first.</source>
            <translation>Die Kräfte sind an; zuerst ausschalten.</translation>
        </message>
        <message>
            <source>The forces go off within a millisecond and stay off until you switch them on.</source>
            <translation>Die Kräfte gehen binnen einer Millisekunde aus und bleiben aus, bis Sie sie einschalten.</translation>
        </message>
        <message>
            <source>The forces that friction holds: the force's arrow lies inside until the contact slips</source>
            <translation>Die Kräfte, die die Reibung hält: Der Kraftpfeil liegt innen, bis der Kontakt gleitet</translation>
        </message>
        <message>
            <source>The guide was not installed with the program.</source>
            <translation>Das Handbuch wurde nicht mit dem Programm installiert.</translation>
        </message>
        <message>
            <source>The handle in the device's workspace, as you see it from the front and from above</source>
            <translation>Der Griff im Arbeitsraum des Geräts, wie Sie ihn von vorn und von oben sehen</translation>
        </message>
        <message>
            <source>The handles lie along the axes of the object selected last</source>
            <translation>Die Anfasser liegen entlang der Achsen des zuletzt gewählten Objekts</translation>
        </message>
        <message>
            <source>The handles lie along the axes of the world</source>
            <translation>Die Anfasser liegen entlang der Achsen der Welt</translation>
        </message>
        <message>
            <source>The hands are the server's.</source>
            <translation>Die Hände gehören dem Server.</translation>
        </message>
        <message>
            <source>The haptic server %1 is not there, and the device is with it. Start it again: the window finds it by itself.</source>
            <translation>Der haptische Server %1 ist nicht da, und das Gerät mit ihm. Ihn wieder starten: Das Fenster findet ihn von selbst.</translation>
        </message>
        <message>
            <source>The highest x of the selected objects becomes that of the one selected last</source>
            <translation>Das größte x der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The highest y of the selected objects becomes that of the one selected last</source>
            <translation>Das größte y der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The highest z of the selected objects becomes that of the one selected last</source>
            <translation>Das größte z der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The hull of each part that shares no corner with the others.</source>
            <translation>Die Hülle jedes Teils, das keine Ecke mit den anderen teilt.</translation>
        </message>
        <message>
            <source>The hulls, boxes and round shapes as which bodies meet each other, over the model</source>
            <translation>Die Hüllen, Boxen und runden Formen, als die sich Körper begegnen, über dem Modell</translation>
        </message>
        <message>
            <source>The last minute was saved to %1.</source>
            <translation>Die letzte Minute wurde nach %1 gespeichert.</translation>
        </message>
        <message>
            <source>The last one</source>
            <translation>Das letzte</translation>
        </message>
        <message>
            <source>The last point leads to the first again; else its ends are stops</source>
            <translation>Der letzte Punkt führt wieder zum ersten; sonst sind die Enden Anschläge</translation>
        </message>
        <message>
            <source>The last stroke was not on this surface. Stroke it with the finger.</source>
            <translation>Der letzte Strich war nicht auf dieser Oberfläche. Mit dem Finger über sie streichen.</translation>
        </message>
        <message>
            <source>The layers along the last stroke</source>
            <translation>Die Ebenen entlang des letzten Strichs</translation>
        </message>
        <message>
            <source>The layers on a piece of flat ground, lit from the upper left, with details as far as they can be seen. What is painted counts as painted everywhere. The wheel shows more or less ground.</source>
            <translation>Die Ebenen auf einem Stück ebenem Grund, von links oben beleuchtet, mit Einzelheiten, soweit sie zu sehen sind. Gemaltes gilt als überall gemalt. Das Mausrad zeigt mehr oder weniger Grund.</translation>
        </message>
        <message>
            <source>The layers on flat ground</source>
            <translation>Die Ebenen auf ebenem Grund</translation>
        </message>
        <message>
            <source>The logs come beside %1.</source>
            <translation>Die Protokolle kommen neben %1.</translation>
        </message>
        <message>
            <source>The longest time between two ticks of the servo in the last seconds: so long the force stood still. After %1 ms it is taken away until the ticks come again.</source>
            <translation>Die längste Zeit zwischen zwei Takten des Servos in den letzten Sekunden: So lange stand die Kraft still. Nach %1 ms wird sie weggenommen, bis die Takte wieder kommen.</translation>
        </message>
        <message>
            <source>The loops run with no real-time priority</source>
            <translation>Die Schleifen laufen ohne Echtzeitpriorität</translation>
        </message>
        <message>
            <source>The loops run with real-time priority </source>
            <translation>Die Schleifen laufen mit Echtzeitpriorität </translation>
        </message>
        <message>
            <source>The lowest x of the selected objects becomes that of the one selected last</source>
            <translation>Das kleinste x der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The lowest y of the selected objects becomes that of the one selected last</source>
            <translation>Das kleinste y der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The lowest z of the selected objects becomes that of the one selected last</source>
            <translation>Das kleinste z der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The measure is on the clipboard.</source>
            <translation>Das Maß ist in der Zwischenablage.</translation>
        </message>
        <message>
            <source>The mesh has no texture coordinates, so it is not felt. Triplanar needs none.</source>
            <translation>Das Netz hat keine Texturkoordinaten, daher wird sie nicht gefühlt. Triplanar braucht keine.</translation>
        </message>
        <message>
            <source>The middle of the device's workspace comes to the middle of the model</source>
            <translation>Die Mitte des Geräte-Arbeitsraums kommt in die Mitte des Modells</translation>
        </message>
        <message>
            <source>The middle of the view</source>
            <translation>Mitte der Ansicht</translation>
        </message>
        <message>
            <source>The middle of the workspace comes to the middle of the model</source>
            <translation>Die Mitte des Arbeitsraums kommt in die Mitte des Modells</translation>
        </message>
        <message>
            <source>The middle x of the selected objects becomes that of the one selected last</source>
            <translation>Das mittlere x der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The middle y of the selected objects becomes that of the one selected last</source>
            <translation>Das mittlere y der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The middle z of the selected objects becomes that of the one selected last</source>
            <translation>Das mittlere z der ausgewählten Objekte wird das des zuletzt ausgewählten</translation>
        </message>
        <message>
            <source>The middles of three or more selected objects; the outer two stay</source>
            <translation>Die Mitten von drei oder mehr ausgewählten Objekten; die beiden äußeren bleiben</translation>
        </message>
        <message>
            <source>The model was %1 across and has been scaled to %2 so that it fits a hand. Undo brings its own size back.</source>
            <translation>Das Modell war %1 groß und wurde auf %2 skaliert, passend zur Hand. Rückgängig bringt seine eigene Größe zurück.</translation>
        </message>
        <message>
            <source>The most that its motor can do; 0: it has none.</source>
            <translation>Das Meiste, was sein Motor leistet; 0: Er hat keinen.</translation>
        </message>
        <message>
            <source>The motors are getting warm.</source>
            <translation>Die Motoren werden warm.</translation>
        </message>
        <message>
            <source>The motors are getting warm: if you press on as hard, the largest force falls within seconds to what they bear for ever. Press less, or let them rest.</source>
            <translation>Die Motoren werden warm: Wird weiter so stark gedrückt, sinkt die größte Kraft binnen Sekunden auf das, was sie dauerhaft aushalten. Weniger drücken oder sie ruhen lassen.</translation>
        </message>
        <message>
            <source>The motors do not feel the known mass: it did not hang freely, or they are far too strong.</source>
            <translation>Die Motoren spüren die bekannte Masse nicht: Sie hing nicht frei, oder sie sind viel zu stark.</translation>
        </message>
        <message>
            <source>The motors push %1 times as hard as they are told, along y: calibrate the driver (docs/devices.md).</source>
            <translation>Die Motoren drücken entlang y das %1-Fache dessen, was ihnen gesagt wird: den Treiber kalibrieren (docs/devices.md).</translation>
        </message>
        <message>
            <source>The motors push along %1 when they should along %2.</source>
            <translation>Die Motoren drücken entlang %1, wo sie es entlang %2 sollten.</translation>
        </message>
        <message>
            <source>The motors push the other way along %1.</source>
            <translation>Die Motoren drücken entlang %1 andersherum.</translation>
        </message>
        <message>
            <source>The mouse leads one hand alone; connect a device first.</source>
            <translation>Die Maus führt nur eine Hand; zuerst ein Gerät verbinden.</translation>
        </message>
        <message>
            <source>The mouse leads the simulated hand in the scene itself.</source>
            <translation>Die Maus führt die simulierte Hand in der Szene selbst.</translation>
        </message>
        <message>
            <source>The next drag takes what its line goes round; with Shift also, with Ctrl not any more</source>
            <translation>Das nächste Ziehen wählt, was seine Linie umschließt; mit Umschalt zusätzlich, mit Strg nicht mehr</translation>
        </message>
        <message>
            <source>The next drag takes what lies in a box; with Shift also, with Ctrl not any more</source>
            <translation>Das nächste Ziehen wählt, was in einer Box liegt; mit Umschalt zusätzlich, mit Strg nicht mehr</translation>
        </message>
        <message>
            <source>The object</source>
            <translation>Objekt</translation>
        </message>
        <message>
            <source>The objects of the scene and their surfaces.

Open a model (Ctrl+O), add one or a simple form (File &gt; Add), or drop one on the window.</source>
            <translation>Die Objekte der Szene und ihre Oberflächen.

Ein Modell öffnen (Strg+O), eines oder eine einfache Form hinzufügen (Datei &gt; Hinzufügen) oder auf dem Fenster ablegen.</translation>
        </message>
        <message>
            <source>The other selected surfaces feel like the one that was selected last</source>
            <translation>Die anderen gewählten Oberflächen fühlen sich an wie die zuletzt gewählte</translation>
        </message>
        <message>
            <source>The other triangles of the object, or the other surfaces where no triangle is selected</source>
            <translation>Die anderen Dreiecke des Objekts oder die anderen Oberflächen, wenn kein Dreieck gewählt ist</translation>
        </message>
        <message>
            <source>The parents of the spheres shown</source>
            <translation>Die Eltern der gezeigten Kugeln</translation>
        </message>
        <message>
            <source>The plot was written to %1.</source>
            <translation>Das Diagramm wurde nach %1 geschrieben.</translation>
        </message>
        <message>
            <source>The plots that are shown are in the video, beneath the view</source>
            <translation>Die gezeigten Diagramme sind im Video, unter der Ansicht</translation>
        </message>
        <message>
            <source>The preset %1 was removed.</source>
            <translation>Die Vorgabe %1 wurde entfernt.</translation>
        </message>
        <message>
            <source>The preset was written to %1.</source>
            <translation>Die Vorgabe wurde nach %1 geschrieben.</translation>
        </message>
        <message>
            <source>The process that stops the device in an emergency does not answer.</source>
            <translation>Der Prozess, der das Gerät im Notfall stoppt, antwortet nicht.</translation>
        </message>
        <message>
            <source>The profile, the report and every tick are in %1.</source>
            <translation>Das Profil, der Bericht und jeder Takt sind in %1.</translation>
        </message>
        <message>
            <source>The proxy loop did not answer for 0.1 s.</source>
            <translation>Die Proxyschleife hat 0.1 s lang nicht geantwortet.</translation>
        </message>
        <message>
            <source>The readings hardly change when the handle moves %1: an encoder or its cable is broken.</source>
            <translation>Die Messwerte ändern sich kaum, wenn der Griff sich %1 bewegt: Ein Encoder oder sein Kabel ist defekt.</translation>
        </message>
        <message>
            <source>The report was written to %1.</source>
            <translation>Der Bericht wurde nach %1 geschrieben.</translation>
        </message>
        <message>
            <source>The rule 70-tactum.rules was not installed with the program: install the program anew.</source>
            <translation>Die Regel 70-tactum.rules wurde nicht mit dem Programm installiert: das Programm neu installieren.</translation>
        </message>
        <message>
            <source>The same layer once more, above it</source>
            <translation>Dieselbe Ebene noch einmal, über ihr</translation>
        </message>
        <message>
            <source>The scene as it is now becomes a condition of the study, under a name</source>
            <translation>Die Szene, wie sie jetzt ist, wird unter einem Namen zu einer Bedingung der Studie</translation>
        </message>
        <message>
            <source>The scene as it is now becomes a condition, under a name</source>
            <translation>Die Szene, wie sie jetzt ist, wird unter einem Namen zu einer Bedingung</translation>
        </message>
        <message>
            <source>The scene as it is now is what edits are held against</source>
            <translation>Die Szene, wie sie jetzt ist, ist das, woran Änderungen gemessen werden</translation>
        </message>
        <message>
            <source>The scene asked for a force that is no number.</source>
            <translation>Die Szene verlangte eine Kraft, die keine Zahl ist.</translation>
        </message>
        <message>
            <source>The scene becomes A again, and A what the scene was</source>
            <translation>Die Szene wird wieder A, und A, was die Szene war</translation>
        </message>
        <message>
            <source>The scene becomes A again, and A what the scene was; Undo takes it back</source>
            <translation>Die Szene wird wieder A, und A, was die Szene war; Rückgängig nimmt es zurück</translation>
        </message>
        <message>
            <source>The scene becomes the chosen condition again</source>
            <translation>Die Szene wird wieder die gewählte Bedingung</translation>
        </message>
        <message>
            <source>The scene becomes the chosen condition; Undo takes it back</source>
            <translation>Die Szene wird die gewählte Bedingung; Rückgängig nimmt es zurück</translation>
        </message>
        <message>
            <source>The scene is felt already.</source>
            <translation>Die Szene wird schon gefühlt.</translation>
        </message>
        <message>
            <source>The scene is not touched. Afterwards the window has the device again, with the forces off.</source>
            <translation>Die Szene bleibt unberührt. Danach hat das Fenster das Gerät wieder, mit ausgeschalteten Kräften.</translation>
        </message>
        <message>
            <source>The scene was saved to %1.</source>
            <translation>Die Szene wurde nach %1 gespeichert.</translation>
        </message>
        <message>
            <source>The selected object gets a mass, falls, and is pushed by the hand</source>
            <translation>Das gewählte Objekt bekommt eine Masse, fällt und wird von der Hand geschoben</translation>
        </message>
        <message>
            <source>The selected object moves no more</source>
            <translation>Das gewählte Objekt bewegt sich nicht mehr</translation>
        </message>
        <message>
            <source>The selected object rides on a curve, whose points are dragged in the view</source>
            <translation>Das gewählte Objekt fährt auf einer Kurve, deren Punkte in der Ansicht gezogen werden</translation>
        </message>
        <message>
            <source>The selected object slides along its length; the dock Body changes it</source>
            <translation>Das gewählte Objekt gleitet entlang seiner Länge; der Bereich Körper ändert es</translation>
        </message>
        <message>
            <source>The selected object turns about an edge, as its form suggests; the dock Body changes it</source>
            <translation>Das gewählte Objekt dreht sich um eine Kante, wie seine Form es nahelegt; der Bereich Körper ändert es</translation>
        </message>
        <message>
            <source>The selected objects become a group under a name, which is selected, moved and hidden as a whole</source>
            <translation>Die ausgewählten Objekte werden eine Gruppe mit einem Namen, die im Ganzen ausgewählt, bewegt und ausgeblendet wird</translation>
        </message>
        <message>
            <source>The selected objects come before the one above them in the list; dragging their rows does the same</source>
            <translation>Die ausgewählten Objekte kommen in der Liste vor das über ihnen; ihre Zeilen zu ziehen tut dasselbe</translation>
        </message>
        <message>
            <source>The selected objects come behind the one below them in the list</source>
            <translation>Die ausgewählten Objekte kommen in der Liste hinter das unter ihnen</translation>
        </message>
        <message>
            <source>The selected objects come down onto what is beneath them, or on the ground</source>
            <translation>Die gewählten Objekte kommen herab auf das, was unter ihnen ist, oder auf den Boden</translation>
        </message>
        <message>
            <source>The selected surfaces are neither seen nor felt until they are shown again</source>
            <translation>Die gewählten Oberflächen sind weder zu sehen noch zu fühlen, bis sie wieder eingeblendet werden</translation>
        </message>
        <message>
            <source>The selected surfaces feel like the copied one</source>
            <translation>Die gewählten Oberflächen fühlen sich an wie die kopierte</translation>
        </message>
        <message>
            <source>The selected surfaces get the values of the preset that is chosen in the library</source>
            <translation>Die gewählten Oberflächen bekommen die Werte der Vorgabe, die in der Bibliothek gewählt ist</translation>
        </message>
        <message>
            <source>The selected surfaces of one object become one, which feels like the one selected last</source>
            <translation>Die gewählten Oberflächen eines Objekts werden eine, die sich anfühlt wie die zuletzt gewählte</translation>
        </message>
        <message>
            <source>The selected triangles become a surface of their own</source>
            <translation>Die gewählten Dreiecke werden eine eigene Oberfläche</translation>
        </message>
        <message>
            <source>The selected triangles, else the selected surfaces, get their front on the other side</source>
            <translation>Die gewählten Dreiecke, sonst die gewählten Oberflächen, bekommen ihre Vorderseite auf der anderen Seite</translation>
        </message>
        <message>
            <source>The selection under a name, saved with the scene, to be selected again</source>
            <translation>Die Auswahl unter einem Namen, mit der Szene gespeichert, um sie wieder auszuwählen</translation>
        </message>
        <message>
            <source>The self-test has ended without a result. The forces are off.</source>
            <translation>Der Selbsttest ist ohne Ergebnis zu Ende. Die Kräfte sind aus.</translation>
        </message>
        <message>
            <source>The servo or the device stood still for more than 10 ms.</source>
            <translation>Der Servo oder das Gerät stand länger als 10 ms still.</translation>
        </message>
        <message>
            <source>The servo stands still: the device does not come back. Look at its cable and its power.</source>
            <translation>Der Servo steht still: Das Gerät kommt nicht zurück. Kabel und Stromversorgung prüfen.</translation>
        </message>
        <message>
            <source>The shapes are those of %1 now and feel as before. Undo takes them back.</source>
            <translation>Die Formen sind jetzt die von %1 und fühlen sich an wie zuvor. Rückgängig nimmt sie zurück.</translation>
        </message>
        <message>
            <source>The shapes are those of %1 now.%2 %3.</source>
            <translation>Die Formen sind jetzt die von %1.%2 %3.</translation>
        </message>
        <message>
            <source>The simulated hand is not there yet.</source>
            <translation>Die simulierte Hand ist noch nicht da.</translation>
        </message>
        <message>
            <source>The stiffest visible surface of the scene, the bar; the mark is the ceiling.</source>
            <translation>Die steifste sichtbare Oberfläche der Szene, der Balken; die Marke ist die Steifigkeitsgrenze.</translation>
        </message>
        <message>
            <source>The stiffness ceiling fell from %1 to %2 N/m: %3.</source>
            <translation>Die Steifigkeitsgrenze ist von %1 auf %2 N/m gesunken: %3.</translation>
        </message>
        <message>
            <source>The stiffness ceiling rose from %1 to %2 N/m: %3.</source>
            <translation>Die Steifigkeitsgrenze ist von %1 auf %2 N/m gestiegen: %3.</translation>
        </message>
        <message>
            <source>The stiffness that the hand gets of what it touches now.</source>
            <translation>Die Steifigkeit, die die Hand von dem bekommt, was sie gerade berührt.</translation>
        </message>
        <message>
            <source>The stiffness up to which device, hand and sampling stay calm. Stiffer surfaces are rendered with it. A firmer grip, a faster servo and a device with more damping raise it.</source>
            <translation>Die Steifigkeit, bis zu der Gerät, Hand und Abtastung ruhig bleiben. Steifere Oberflächen werden mit ihr gerendert. Festeres Halten, ein schnellerer Servo und ein Gerät mit mehr Dämpfung erhöhen sie.</translation>
        </message>
        <message>
            <source>The stroke is felt in A and in the scene</source>
            <translation>Der Strich wird in A und in der Szene gefühlt</translation>
        </message>
        <message>
            <source>The stroke is what the finger did in the last ten seconds</source>
            <translation>Der Strich ist, was der Finger in den letzten zehn Sekunden tat</translation>
        </message>
        <message>
            <source>The study cannot be run yet; the dock Study says why.</source>
            <translation>Die Studie kann noch nicht durchgeführt werden; der Bereich Studie sagt, warum.</translation>
        </message>
        <message>
            <source>The study goes on without it</source>
            <translation>Die Studie geht ohne sie weiter</translation>
        </message>
        <message>
            <source>The study has ended: %1</source>
            <translation>Die Studie ist beendet: %1</translation>
        </message>
        <message>
            <source>The study has no condition yet.</source>
            <translation>Die Studie hat noch keine Bedingung.</translation>
        </message>
        <message>
            <source>The study has not been saved. Study &gt; Save the study as... keeps it.</source>
            <translation>Die Studie wurde nicht gespeichert. Studie &gt; Studie speichern unter... bewahrt sie.</translation>
        </message>
        <message>
            <source>The study was saved to %1.</source>
            <translation>Die Studie wurde nach %1 gespeichert.</translation>
        </message>
        <message>
            <source>The surface is locked, so it gets no layer; unlock it first (L).</source>
            <translation>Die Oberfläche ist gesperrt und bekommt daher keine Ebene; zuerst entsperren (L).</translation>
        </message>
        <message>
            <source>The surface is locked: press L to unlock it.</source>
            <translation>Die Oberfläche ist gesperrt: L drücken zum Entsperren.</translation>
        </message>
        <message>
            <source>The surface that the finger touches, or has touched last; also while it is held</source>
            <translation>Die Oberfläche, die der Finger berührt oder zuletzt berührt hat; auch während er gehalten wird</translation>
        </message>
        <message>
            <source>The system did not allow it. Run this line in a terminal, then plug the device in anew:</source>
            <translation>Das System hat es nicht erlaubt. Diese Zeile in einem Terminal ausführen, dann das Gerät neu anschließen:</translation>
        </message>
        <message>
            <source>The triangles of the model as lines</source>
            <translation>Die Dreiecke des Modells als Linien</translation>
        </message>
        <message>
            <source>The triangles that are kept under this name</source>
            <translation>Die Dreiecke, die unter diesem Namen behalten sind</translation>
        </message>
        <message>
            <source>The values of a painted layer, or the image of one that lies on texture coordinates</source>
            <translation>Die Werte einer gemalten Ebene oder das Bild einer, die auf Texturkoordinaten liegt</translation>
        </message>
        <message>
            <source>The video was written to %1: %2 s.</source>
            <translation>Das Video wurde nach %1 geschrieben: %2 s.</translation>
        </message>
        <message>
            <source>The view alone on the whole screen, with larger words and a larger contact; Esc comes back</source>
            <translation>Nur die Ansicht auf dem ganzen Bildschirm, mit größeren Texten und größerem Kontakt; Esc führt zurück</translation>
        </message>
        <message>
            <source>The view alone; Tab does the same while the view has the focus</source>
            <translation>Die Ansicht allein; Tab tut dasselbe, wenn die Ansicht den Fokus hat</translation>
        </message>
        <message>
            <source>The view from there is no longer kept</source>
            <translation>Die Ansicht von dort ist nicht mehr gespeichert</translation>
        </message>
        <message>
            <source>The view was written to %1.</source>
            <translation>Die Ansicht wurde nach %1 geschrieben.</translation>
        </message>
        <message>
            <source>The way along %1 is read along %2.</source>
            <translation>Der Weg entlang %1 wird entlang %2 gelesen.</translation>
        </message>
        <message>
            <source>The wheel makes it larger and smaller</source>
            <translation>Das Mausrad vergrößert und verkleinert</translation>
        </message>
        <message>
            <source>The wheel turned away</source>
            <translation>Mausrad von sich weg</translation>
        </message>
        <message>
            <source>The window for %1 cannot be started: install the program again.</source>
            <translation>Das Fenster für %1 kann nicht gestartet werden: das Programm neu installieren.</translation>
        </message>
        <message>
            <source>The workspace drifts along when the finger is pressed against its edge</source>
            <translation>Der Arbeitsraum wandert mit, wenn der Finger gegen seinen Rand gedrückt wird</translation>
        </message>
        <message>
            <source>The world</source>
            <translation>Welt</translation>
        </message>
        <message>
            <source>The y axis of the file points up</source>
            <translation>Die y-Achse der Datei zeigt nach oben</translation>
        </message>
        <message>
            <source>The z axis of the file points up</source>
            <translation>Die z-Achse der Datei zeigt nach oben</translation>
        </message>
        <message>
            <source>The&amp;me</source>
            <translation>Desi&amp;gn</translation>
        </message>
        <message>
            <source>Theme</source>
            <translation>Design</translation>
        </message>
        <message>
            <source>There are as many hands as can be; remove one first.</source>
            <translation>Es gibt so viele Hände, wie es geben kann; zuerst eine entfernen.</translation>
        </message>
        <message>
            <source>There are several hands; remove the others first.</source>
            <translation>Es gibt mehrere Hände; zuerst die anderen entfernen.</translation>
        </message>
        <message>
            <source>There is a camera %1 already; View &gt; Camera &gt; Kept cameras &gt; Replace by this view makes it another one.</source>
            <translation>Es gibt schon eine Kamera %1; Ansicht &gt; Kamera &gt; Gespeicherte Kameras &gt; Durch diese Ansicht ersetzen macht eine andere daraus.</translation>
        </message>
        <message>
            <source>There is a camera %1 already; choose another name.</source>
            <translation>Es gibt schon eine Kamera %1; wählen Sie einen anderen Namen.</translation>
        </message>
        <message>
            <source>There is a set %1 already; Sets &gt; Replace by the selection makes it another one.</source>
            <translation>Einen Satz %1 gibt es schon; Sätze &gt; Durch die Auswahl ersetzen macht einen anderen daraus.</translation>
        </message>
        <message>
            <source>There is a set %1 already; choose another name.</source>
            <translation>Einen Satz %1 gibt es schon; bitte einen anderen Namen wählen.</translation>
        </message>
        <message>
            <source>There is no edit to take back.</source>
            <translation>Es gibt keine Änderung, die zurückzunehmen wäre.</translation>
        </message>
        <message>
            <source>There is no stroke, or no state was marked as A.</source>
            <translation>Es gibt keinen Strich, oder kein Zustand wurde als A markiert.</translation>
        </message>
        <message>
            <source>There is one hand.</source>
            <translation>Es gibt nur eine Hand.</translation>
        </message>
        <message>
            <source>There was a fault. What led to it was saved: open %1 to see it again.</source>
            <translation>Es gab eine Störung. Was dazu führte, wurde gespeichert: %1 öffnen, um es noch einmal zu sehen.</translation>
        </message>
        <message>
            <source>They are aligned already.</source>
            <translation>Sie sind schon ausgerichtet.</translation>
        </message>
        <message>
            <source>They are lost otherwise.</source>
            <translation>Sie gehen sonst verloren.</translation>
        </message>
        <message>
            <source>They feel as before</source>
            <translation>Sie fühlen sich an wie zuvor</translation>
        </message>
        <message>
            <source>This button ends all force</source>
            <translation>Diese Taste beendet alle Kraft</translation>
        </message>
        <message>
            <source>This device has no button that could be held.</source>
            <translation>Dieses Gerät hat keine Taste, die gehalten werden könnte.</translation>
        </message>
        <message>
            <source>This device has no button.</source>
            <translation>Dieses Gerät hat keine Taste.</translation>
        </message>
        <message>
            <source>This device is in use already.</source>
            <translation>Dieses Gerät ist schon in Gebrauch.</translation>
        </message>
        <message>
            <source>This is wrong:</source>
            <translation>Dies ist falsch:</translation>
        </message>
        <message>
            <source>This machine has no audio output</source>
            <translation>Dieser Rechner hat keinen Audioausgang</translation>
        </message>
        <message>
            <source>Three small scenes to feel whether a device works as it should. Your own scene waits, unchanged.</source>
            <translation>Drei kleine Szenen, um zu fühlen, ob ein Gerät arbeitet, wie es soll. Ihre eigene Szene wartet unverändert.</translation>
        </message>
        <message>
            <source>Threshold of the last</source>
            <translation>Schwelle aus den letzten</translation>
        </message>
        <message>
            <source>Through</source>
            <translation>Hindurch</translation>
        </message>
        <message>
            <source>Through the mo&amp;del</source>
            <translation>Durch das Modell hi&amp;ndurch</translation>
        </message>
        <message>
            <source>Throw %1 away</source>
            <translation>%1 verwerfen</translation>
        </message>
        <message>
            <source>Throw away</source>
            <translation>Verwerfen</translation>
        </message>
        <message>
            <source>Ticks a second of the loop that commands the device, and how many there should be. Fewer: close what else keeps the machine busy, or allow real-time priority.</source>
            <translation>Takte je Sekunde der Schleife, die das Gerät steuert, und wie viele es sein sollten. Weniger: schließen, was den Rechner sonst beschäftigt, oder Echtzeitpriorität erlauben.</translation>
        </message>
        <message>
            <source>Ticks that came more than a period late. The machine's are those in which the loop itself had hardly worked: no program can help it. Our own are worth a report.</source>
            <translation>Takte, die mehr als eine Periode zu spät kamen. Die der Maschine sind solche, in denen die Schleife selbst kaum gearbeitet hatte: Dagegen hilft kein Programm. Unsere eigenen sind einen Bericht wert.</translation>
        </message>
        <message>
            <source>Time in the recording</source>
            <translation>Zeit in der Aufnahme</translation>
        </message>
        <message>
            <source>Time scale</source>
            <translation>Zeitmaßstab</translation>
        </message>
        <message>
            <source>To the right (x)</source>
            <translation>Nach rechts (x)</translation>
        </message>
        <message>
            <source>Tools</source>
            <translation>Werkzeuge</translation>
        </message>
        <message>
            <source>Tools that have no room</source>
            <translation>Werkzeuge, für die kein Platz ist</translation>
        </message>
        <message>
            <source>Top</source>
            <translation>Oben</translation>
        </message>
        <message>
            <source>Torque against each radian a second.</source>
            <translation>Drehmoment gegen jeden Radiant je Sekunde.</translation>
        </message>
        <message>
            <source>Torque for each radian away from where the spring rests.</source>
            <translation>Drehmoment für jeden Radiant weg von der Ruhelage der Feder.</translation>
        </message>
        <message>
            <source>Touch a model</source>
            <translation>Ein Modell berühren</translation>
        </message>
        <message>
            <source>Touch it.</source>
            <translation>Bitte berühren Sie es.</translation>
        </message>
        <message>
            <source>Touch over time</source>
            <translation>Berührung über der Zeit</translation>
        </message>
        <message>
            <source>Touch: drag on the model to lead the finger</source>
            <translation>Berühren: auf dem Modell ziehen, um den Finger zu führen</translation>
        </message>
        <message>
            <source>Toward you (z)</source>
            <translation>Zu Ihnen hin (z)</translation>
        </message>
        <message>
            <source>Trail of the last %1 s: line slipping, beads sticking</source>
            <translation>Spur der letzten %1 s: Linie gleitet, Perlen haften</translation>
        </message>
        <message>
            <source>Triangle</source>
            <translation>Dreieck</translation>
        </message>
        <message>
            <source>Triplanar</source>
            <translation>Triplanar</translation>
        </message>
        <message>
            <source>Try again</source>
            <translation>Noch einmal</translation>
        </message>
        <message>
            <source>Try i&amp;t</source>
            <translation>&amp;Testen</translation>
        </message>
        <message>
            <source>Try it</source>
            <translation>Testen</translation>
        </message>
        <message>
            <source>Try: %1</source>
            <translation>Testen: %1</translation>
        </message>
        <message>
            <source>Turn %1</source>
            <translation>%1 drehen</translation>
        </message>
        <message>
            <source>Turn &amp;down</source>
            <translation>Nach &amp;unten drehen</translation>
        </message>
        <message>
            <source>Turn &amp;left</source>
            <translation>Nach &amp;links drehen</translation>
        </message>
        <message>
            <source>Turn &amp;over</source>
            <translation>&amp;Umdrehen</translation>
        </message>
        <message>
            <source>Turn &amp;right</source>
            <translation>Nach &amp;rechts drehen</translation>
        </message>
        <message>
            <source>Turn &amp;up</source>
            <translation>Nach &amp;oben drehen</translation>
        </message>
        <message>
            <source>Turn over</source>
            <translation>Umdrehen</translation>
        </message>
        <message>
            <source>Turn triangles over until neighbours agree, with the front outside.</source>
            <translation>Dreiecke umdrehen, bis Nachbarn übereinstimmen, mit der Vorderseite außen.</translation>
        </message>
        <message>
            <source>Turned about x</source>
            <translation>Gedreht um x</translation>
        </message>
        <message>
            <source>Turned about x, then y, then z of the world.</source>
            <translation>Gedreht um x, dann y, dann z der Welt.</translation>
        </message>
        <message>
            <source>Turned about y</source>
            <translation>Gedreht um y</translation>
        </message>
        <message>
            <source>Turned about z</source>
            <translation>Gedreht um z</translation>
        </message>
        <message>
            <source>Turning</source>
            <translation>Drehen</translation>
        </message>
        <message>
            <source>Turns about</source>
            <translation>Drehpunkt</translation>
        </message>
        <message>
            <source>Twenty bodies on strings, all moved by one finger</source>
            <translation>Zwanzig Körper an Fäden, von einem Finger bewegt</translation>
        </message>
        <message>
            <source>Two clicks: distance; a third: angle at the second</source>
            <translation>Zwei Klicks: Abstand; ein dritter: Winkel am zweiten</translation>
        </message>
        <message>
            <source>Two intervals: one has the reference</source>
            <translation>Zwei Intervalle: eines hat die Referenz</translation>
        </message>
        <message>
            <source>Two one &amp;above the other</source>
            <translation>Zwei ü&amp;bereinander</translation>
        </message>
        <message>
            <source>Two views one above the other, your own and one from the right; again for one view</source>
            <translation>Zwei Ansichten übereinander, die eigene und eine von rechts; noch einmal für eine Ansicht</translation>
        </message>
        <message>
            <source>Two views side by side, your own and one from the right; again for one view</source>
            <translation>Zwei Ansichten nebeneinander, die eigene und eine von rechts; noch einmal für eine Ansicht</translation>
        </message>
        <message>
            <source>Two ways of the handle are read along one axis: an encoder or its cable is broken, or the ruler lay askew.</source>
            <translation>Zwei Wege des Griffs werden entlang einer Achse gelesen: Ein Encoder oder sein Kabel ist defekt, oder das Lineal lag schief.</translation>
        </message>
        <message>
            <source>Type a number above 0, then Enter.</source>
            <translation>Bitte geben Sie eine Zahl über 0 ein und drücken Sie dann Eingabe.</translation>
        </message>
        <message>
            <source>Type, then Enter.</source>
            <translation>Bitte schreiben Sie und drücken Sie dann Eingabe.</translation>
        </message>
        <message>
            <source>UV, in metres</source>
            <translation>UV, in Metern</translation>
        </message>
        <message>
            <source>UV, unit square</source>
            <translation>UV, Einheitsquadrat</translation>
        </message>
        <message>
            <source>Undo</source>
            <translation>Rückgängig</translation>
        </message>
        <message>
            <source>Undo the last edit, then arm again.</source>
            <translation>Die letzte Änderung rückgängig machen, dann Kräfte wieder einschalten.</translation>
        </message>
        <message>
            <source>Unfold these panels</source>
            <translation>Diese Bereiche ausklappen</translation>
        </message>
        <message>
            <source>Unlock %1</source>
            <translation>%1 entsperren</translation>
        </message>
        <message>
            <source>Unlock: let it be edited again (L)</source>
            <translation>Entsperren: wieder bearbeitbar machen (L)</translation>
        </message>
        <message>
            <source>Unsaved changes</source>
            <translation>Ungespeicherte Änderungen</translation>
        </message>
        <message>
            <source>Up (y)</source>
            <translation>Nach oben (y)</translation>
        </message>
        <message>
            <source>Up to this force it stays where it is.</source>
            <translation>Bis zu dieser Kraft bleibt er, wo er ist.</translation>
        </message>
        <message>
            <source>Up to this torque it stays where it is.</source>
            <translation>Bis zu diesem Drehmoment bleibt er, wo er ist.</translation>
        </message>
        <message>
            <source>Update geometry</source>
            <translation>Geometrie aktualisieren</translation>
        </message>
        <message>
            <source>Update geometry from %1</source>
            <translation>Geometrie aus %1 aktualisieren</translation>
        </message>
        <message>
            <source>Update geometry from a file</source>
            <translation>Geometrie aus einer Datei aktualisieren</translation>
        </message>
        <message>
            <source>Updates a second of the loop that moves the proxy, and how many there should be. Fewer: the scene is heavy. The force stays smooth; details come later.</source>
            <translation>Aktualisierungen je Sekunde der Schleife, die den Proxy bewegt, und wie viele es sein sollten. Weniger: Die Szene ist schwer. Die Kraft bleibt glatt; Einzelheiten kommen später.</translation>
        </message>
        <message>
            <source>Upper stop</source>
            <translation>Oberer Anschlag</translation>
        </message>
        <message>
            <source>Value</source>
            <translation>Wert</translation>
        </message>
        <message>
            <source>Values and sources</source>
            <translation>Werte und Quellen</translation>
        </message>
        <message>
            <source>Values of the preset and their sources</source>
            <translation>Werte der Vorgabe und ihre Quellen</translation>
        </message>
        <message>
            <source>Version and licence</source>
            <translation>Version und Lizenz</translation>
        </message>
        <message>
            <source>Vertices at the same place become one, so that normals run smoothly over them</source>
            <translation>Ecken an derselben Stelle werden eine, sodass Normalen glatt darüber verlaufen</translation>
        </message>
        <message>
            <source>Videos</source>
            <translation>Videos</translation>
        </message>
        <message>
            <source>View</source>
            <translation>Ansicht</translation>
        </message>
        <message>
            <source>View %1</source>
            <translation>Ansicht %1</translation>
        </message>
        <message>
            <source>Viscosity</source>
            <translation>Viskosität</translation>
        </message>
        <message>
            <source>Wall</source>
            <translation>Wand</translation>
        </message>
        <message>
            <source>Walls thinner than the proxy: around them, never through</source>
            <translation>Wände, dünner als der Proxy: um sie herum, nie hindurch</translation>
        </message>
        <message>
            <source>Warning</source>
            <translation>Warnung</translation>
        </message>
        <message>
            <source>Weave</source>
            <translation>Gewebe</translation>
        </message>
        <message>
            <source>Welcome</source>
            <translation>Willkommen</translation>
        </message>
        <message>
            <source>Weld vertices</source>
            <translation>Ecken verschweißen</translation>
        </message>
        <message>
            <source>What %1 really is, in about ten minutes</source>
            <translation>Was %1 wirklich ist, in etwa zehn Minuten</translation>
        </message>
        <message>
            <source>What a newton is</source>
            <translation>Was ein Newton ist</translation>
        </message>
        <message>
            <source>What a trial is, in which order trials come, and what is asked</source>
            <translation>Was ein Durchgang ist, in welcher Reihenfolge Durchgänge kommen und was gefragt wird</translation>
        </message>
        <message>
            <source>What bodies meet of %1</source>
            <translation>Kollisionskörper von %1</translation>
        </message>
        <message>
            <source>What can be done with what is selected</source>
            <translation>Was sich mit dem Ausgewählten machen lässt</translation>
        </message>
        <message>
            <source>What can you hang on the handle by a thread? Some coins, for instance, whose mass you know; better 50 g than 10, at most %1 g.</source>
            <translation>Was können Sie an einem Faden an den Griff hängen? Ein paar Münzen zum Beispiel, deren Masse Sie kennen; lieber 50 g als 10, höchstens %1 g.</translation>
        </message>
        <message>
            <source>What do you want to do?</source>
            <translation>Was möchten Sie tun?</translation>
        </message>
        <message>
            <source>What is chosen cannot be used; its row says why.</source>
            <translation>Was gewählt ist, kann nicht benutzt werden; seine Zeile sagt, warum.</translation>
        </message>
        <message>
            <source>What is far away is as large as what is near</source>
            <translation>Fernes ist so groß wie Nahes</translation>
        </message>
        <message>
            <source>What is not as before</source>
            <translation>Was nicht wie zuvor ist</translation>
        </message>
        <message>
            <source>What is selected is locked.</source>
            <translation>Was ausgewählt ist, ist gesperrt.</translation>
        </message>
        <message>
            <source>What is selected is locked; unlock it first (L).</source>
            <translation>Was gewählt ist, ist gesperrt; entsperren Sie es zuerst (L).</translation>
        </message>
        <message>
            <source>What is selected, and its area</source>
            <translation>Was ausgewählt ist, und seine Fläche</translation>
        </message>
        <message>
            <source>What is t&amp;ouched</source>
            <translation>Was be&amp;rührt wird</translation>
        </message>
        <message>
            <source>What is touched from nearby, in a corner of the view; the wheel over it makes it larger</source>
            <translation>Was berührt wird, von nahem, in einer Ecke der Ansicht; das Mausrad darüber vergrößert es</translation>
        </message>
        <message>
            <source>What is touched, and whether friction holds or slides</source>
            <translation>Was berührt wird, und ob die Reibung hält oder gleitet</translation>
        </message>
        <message>
            <source>What it feels like</source>
            <translation>Wie es sich anfühlt</translation>
        </message>
        <message>
            <source>What it is fixed to</source>
            <translation>Woran er fest ist</translation>
        </message>
        <message>
            <source>What it takes to leave a detent.</source>
            <translation>Was nötig ist, um eine Raste zu verlassen.</translation>
        </message>
        <message>
            <source>What its motor drives it at, as far as its force suffices.</source>
            <translation>Womit sein Motor ihn antreibt, soweit die Kraft reicht.</translation>
        </message>
        <message>
            <source>What its motor turns at, as far as its torque suffices.</source>
            <translation>Womit sein Motor dreht, soweit das Drehmoment reicht.</translation>
        </message>
        <message>
            <source>What led to it was saved: %1.</source>
            <translation>Was dazu führte, wurde gespeichert: %1.</translation>
        </message>
        <message>
            <source>What makes bodies fall, along x of the world.</source>
            <translation>Was Körper fallen lässt, entlang x der Welt.</translation>
        </message>
        <message>
            <source>What makes bodies fall, along y of the world: upward.</source>
            <translation>Was Körper fallen lässt, entlang y der Welt: aufwärts.</translation>
        </message>
        <message>
            <source>What makes bodies fall, along z of the world.</source>
            <translation>Was Körper fallen lässt, entlang z der Welt.</translation>
        </message>
        <message>
            <source>What the brush does</source>
            <translation>Was der Pinsel tut</translation>
        </message>
        <message>
            <source>What the brush paints</source>
            <translation>Was der Pinsel malt</translation>
        </message>
        <message>
            <source>What the chosen preset sets, and where each value comes from</source>
            <translation>Was die gewählte Vorgabe setzt, und woher jeder Wert kommt</translation>
        </message>
        <message>
            <source>What the file leaves open: one unit of it is 1 m; offered after opening, like the bar over the view</source>
            <translation>Was die Datei offen lässt: Eine Einheit von ihr ist 1 m; nach dem Öffnen angeboten, wie die Leiste über der Ansicht</translation>
        </message>
        <message>
            <source>What the force shakes with, as sound: texture judged without a device</source>
            <translation>Womit die Kraft zittert, als Ton: Textur ohne Gerät beurteilen</translation>
        </message>
        <message>
            <source>What the layer changes: the height of the surface, or a value of its material. Its strength begins anew where the unit is another one.</source>
            <translation>Was die Ebene ändert: die Höhe der Oberfläche oder einen Wert ihres Materials. Ihre Stärke beginnt neu, wo die Einheit eine andere ist.</translation>
        </message>
        <message>
            <source>What the layers are along the last stroke of the finger over this surface</source>
            <translation>Was die Ebenen entlang des letzten Strichs des Fingers über diese Oberfläche sind</translation>
        </message>
        <message>
            <source>What the mode "set" paints toward.</source>
            <translation>Worauf der Modus "Setzen" hinarbeitet.</translation>
        </message>
        <message>
            <source>What the motors move</source>
            <translation>Was die Motoren bewegen</translation>
        </message>
        <message>
            <source>What the pattern's highest places add to the value of the material, as a part of it; -1 takes it away.</source>
            <translation>Was die höchsten Stellen des Musters zum Wert des Materials hinzufügen, als Teil davon; -1 nimmt ihn weg.</translation>
        </message>
        <message>
            <source>What the selected objects are grouped by goes; all objects stay</source>
            <translation>Die Gruppen der ausgewählten Objekte verschwinden; alle Objekte bleiben</translation>
        </message>
        <message>
            <source>What was answered so far is kept, and the run can be gone on with.</source>
            <translation>Ihre bisherigen Antworten bleiben erhalten, und der Lauf kann fortgesetzt werden.</translation>
        </message>
        <message>
            <source>What was cut away is there, and what was there is cut away</source>
            <translation>Was weggeschnitten war, ist da, und was da war, ist weggeschnitten</translation>
        </message>
        <message>
            <source>What was edited when the program last stopped cannot be recovered: its journal is damaged. It was kept in %1.</source>
            <translation>Was beim letzten Programmende bearbeitet wurde, kann nicht wiederhergestellt werden: Das Journal ist beschädigt. Es wurde in %1 aufbewahrt.</translation>
        </message>
        <message>
            <source>What was measured</source>
            <translation>Was gemessen wurde</translation>
        </message>
        <message>
            <source>What you edit is not kept for the case of a crash: %1</source>
            <translation>Was Sie bearbeiten, wird nicht für den Fall eines Absturzes gesichert: %1</translation>
        </message>
        <message>
            <source>What you touch is still as it was before: %1</source>
            <translation>Was Sie berühren, ist noch, wie es zuvor war: %1</translation>
        </message>
        <message>
            <source>Wheel</source>
            <translation>Mausrad</translation>
        </message>
        <message>
            <source>Wheel, Ctrl+drag while touching</source>
            <translation>Mausrad, Strg+Ziehen beim Berühren</translation>
        </message>
        <message>
            <source>When the proxy loop cannot keep up, textures are left out first, then force shading, then all but the nearest planes. What was left out comes back by itself. Hide objects to help it.</source>
            <translation>Wenn die Proxyschleife nicht mitkommt, werden zuerst Texturen ausgelassen, dann Kraft-Shading, dann alle außer den nächsten Zwangsebenen. Was ausgelassen wurde, kommt von selbst zurück. Objekte auszublenden hilft.</translation>
        </message>
        <message>
            <source>When you go on, press and release each button once within %1 seconds.</source>
            <translation>Nach Weiter jede Taste innerhalb von %1 Sekunden einmal drücken und loslassen.</translation>
        </message>
        <message>
            <source>Where each contact pushes to</source>
            <translation>Wohin jeder Kontakt drückt</translation>
        </message>
        <message>
            <source>Where the camera goes when the wheel is turned away from you.</source>
            <translation>Wohin die Kamera geht, wenn das Mausrad von Ihnen weg gedreht wird.</translation>
        </message>
        <message>
            <source>Where the device says that its handle is: to the right, up, and toward you</source>
            <translation>Wo laut Gerät sein Griff ist: nach rechts, nach oben und zu Ihnen hin</translation>
        </message>
        <message>
            <source>Where the layer counts, and how much</source>
            <translation>Wo die Ebene zählt, und wie sehr</translation>
        </message>
        <message>
            <source>Where the layer counts: all where the mask is light, nothing where it is dark</source>
            <translation>Wo die Ebene zählt: ganz, wo die Maske hell ist, gar nicht, wo sie dunkel ist</translation>
        </message>
        <message>
            <source>Where the middle of its box is, in the world.</source>
            <translation>Wo die Mitte des Quaders ist, in der Welt.</translation>
        </message>
        <message>
            <source>Where the proxy was in the last seconds: beads where it stuck, a line where it slipped</source>
            <translation>Wo der Proxy in den letzten Sekunden war: Perlen, wo er haftete, eine Linie, wo er glitt</translation>
        </message>
        <message>
            <source>Where the spring pulls to; beyond a stop: it presses against it.</source>
            <translation>Wohin die Feder zieht; jenseits eines Anschlags: Sie drückt gegen ihn.</translation>
        </message>
        <message>
            <source>Where the view looks from, under a name, saved with the scene</source>
            <translation>Von wo die Ansicht blickt, unter einem Namen, mit der Szene gespeichert</translation>
        </message>
        <message>
            <source>Whether the camera is seen on its way to a standard view or a problem.</source>
            <translation>Ob die Kamera auf ihrem Weg zu einer Standardansicht oder einem Problem zu sehen ist.</translation>
        </message>
        <message>
            <source>Which axis of the device goes there. Each is used once: the one that had it before gets this one's.</source>
            <translation>Welche Achse des Geräts dorthin geht. Jede wird einmal verwendet: Die Richtung, die sie vorher hatte, bekommt die bisherige dieser.</translation>
        </message>
        <message>
            <source>Which button turns the camera and which moves it sideways. A drag with the left button beside the model turns it always.</source>
            <translation>Welche Taste die Kamera dreht und welche sie seitwärts verschiebt. Ziehen mit der linken Taste neben dem Modell dreht sie immer.</translation>
        </message>
        <message>
            <source>Which devices there are, how the one in use does, and how its workspace lies</source>
            <translation>Welche Geräte es gibt, wie es dem verwendeten geht und wie sein Arbeitsraum liegt</translation>
        </message>
        <message>
            <source>Which of its joints</source>
            <translation>Welches seiner Gelenke</translation>
        </message>
        <message>
            <source>Which of the two did you prefer?</source>
            <translation>Welches der beiden war Ihnen lieber?</translation>
        </message>
        <message>
            <source>Which of the two was X?</source>
            <translation>Welches der beiden war X?</translation>
        </message>
        <message>
            <source>Which of the two was stronger?</source>
            <translation>Welches der beiden war stärker?</translation>
        </message>
        <message>
            <source>Which point keeps its place while the wheel zooms.</source>
            <translation>Welcher Punkt seinen Platz behält, wenn das Mausrad zoomt.</translation>
        </message>
        <message>
            <source>Which way the motors push</source>
            <translation>Wohin die Motoren drücken</translation>
        </message>
        <message>
            <source>Whichever comes first.</source>
            <translation>Was zuerst eintritt.</translation>
        </message>
        <message>
            <source>While this button is held the handle moves and the finger stays</source>
            <translation>Solange diese Taste gehalten wird, bewegt sich der Griff und der Finger bleibt</translation>
        </message>
        <message>
            <source>Whole again</source>
            <translation>Wieder ganz</translation>
        </message>
        <message>
            <source>Whose plots, trail and status are shown</source>
            <translation>Wessen Diagramme, Spur und Status gezeigt werden</translation>
        </message>
        <message>
            <source>Width of one repeat on the surface; for noise, of its coarsest grain. The height of an image follows from its proportions.</source>
            <translation>Breite einer Wiederholung auf der Oberfläche; bei Rauschen die seiner gröbsten Körnung. Die Höhe eines Bilds folgt aus seinen Proportionen.</translation>
        </message>
        <message>
            <source>Width of the edge between low and high as a part of a repeat.</source>
            <translation>Breite der Kante zwischen tief und hoch als Teil einer Wiederholung.</translation>
        </message>
        <message>
            <source>With a participant, whose answers and touch are logged</source>
            <translation>Mit einer teilnehmenden Person, deren Antworten und Berührung protokolliert werden</translation>
        </message>
        <message>
            <source>With the &amp;force plot</source>
            <translation>Mit dem &amp;Kraftdiagramm</translation>
        </message>
        <message>
            <source>With the normals of the mesh</source>
            <translation>Mit den Normalen des Netzes</translation>
        </message>
        <message>
            <source>With the whole hand</source>
            <translation>Mit der ganzen Hand</translation>
        </message>
        <message>
            <source>Without conditions</source>
            <translation>Ohne Bedingungen</translation>
        </message>
        <message>
            <source>Wood</source>
            <translation>Holz</translation>
        </message>
        <message>
            <source>Wood on wood</source>
            <translation>Holz auf Holz</translation>
        </message>
        <message>
            <source>Wood, metal, ...</source>
            <translation>Holz, Metall, ...</translation>
        </message>
        <message>
            <source>Words</source>
            <translation>Texte</translation>
        </message>
        <message>
            <source>Work, mJ</source>
            <translation>Arbeit, mJ</translation>
        </message>
        <message>
            <source>Workspace</source>
            <translation>Arbeitsraum</translation>
        </message>
        <message>
            <source>Worst gap</source>
            <translation>Längste Lücke</translation>
        </message>
        <message>
            <source>Write the plot as CSV, PNG or SVG</source>
            <translation>Das Diagramm als CSV, PNG oder SVG schreiben</translation>
        </message>
        <message>
            <source>Write the scene under another name, and go on with that</source>
            <translation>Die Szene unter einem anderen Namen schreiben und mit diesem weitermachen</translation>
        </message>
        <message>
            <source>Write the scene with all its surfaces as glTF (.glb)</source>
            <translation>Die Szene mit all ihren Oberflächen als glTF (.glb) schreiben</translation>
        </message>
        <message>
            <source>Write the view as a PNG file</source>
            <translation>Die Ansicht als PNG-Datei schreiben</translation>
        </message>
        <message>
            <source>Write what is seen as CSV, PNG or SVG</source>
            <translation>Was zu sehen ist, als CSV, PNG oder SVG schreiben</translation>
        </message>
        <message>
            <source>Write what the view shows as a video, until it is chosen again</source>
            <translation>Was die Ansicht zeigt, als Video schreiben, bis es wieder gewählt wird</translation>
        </message>
        <message>
            <source>Writing the report</source>
            <translation>Bericht wird geschrieben</translation>
        </message>
        <message>
            <source>X</source>
            <translation>X</translation>
        </message>
        <message>
            <source>Y</source>
            <translation>Y</translation>
        </message>
        <message>
            <source>Yes</source>
            <translation>Ja</translation>
        </message>
        <message>
            <source>You are led through these parts, and the test finds how the device reads, which way its motors push, what they move and how late they are.</source>
            <translation>Sie werden durch diese Teile geführt, und der Test findet heraus, wie das Gerät misst, wohin seine Motoren drücken, was sie bewegen und wie spät sie sind.</translation>
        </message>
        <message>
            <source>You may use USB devices now, and real time when you have logged in again. If yours is still not usable, plug it in anew.</source>
            <translation>Sie dürfen USB-Geräte jetzt verwenden, und Echtzeit, wenn Sie sich neu angemeldet haben. Ist Ihres noch nicht verwendbar, es neu anschließen.</translation>
        </message>
        <message>
            <source>You need a ruler, and some coins of known mass on a thread, better 50 g than 10. What you cannot do may be skipped.</source>
            <translation>Sie brauchen ein Lineal und ein paar Münzen bekannter Masse an einem Faden, lieber 50 g als 10. Was Sie nicht tun können, darf ausgelassen werden.</translation>
        </message>
        <message>
            <source>Your own</source>
            <translation>Eigene</translation>
        </message>
        <message>
            <source>Your own view alone</source>
            <translation>Die eigene Ansicht allein</translation>
        </message>
        <message>
            <source>Z</source>
            <translation>Z</translation>
        </message>
        <message>
            <source>Zoom to</source>
            <translation>Zoomen auf</translation>
        </message>
        <message>
            <source>Zooming</source>
            <translation>Zoomen</translation>
        </message>
        <message>
            <source>a body on joints</source>
            <translation>ein Körper an Gelenken</translation>
        </message>
        <message>
            <source>a group</source>
            <translation>eine Gruppe</translation>
        </message>
        <message>
            <source>a loose body</source>
            <translation>ein loser Körper</translation>
        </message>
        <message>
            <source>a number</source>
            <translation>keine Zahl</translation>
        </message>
        <message>
            <source>a number in %1</source>
            <translation>keine Zahl in %1</translation>
        </message>
        <message>
            <source>all that was to come after the end that you asked for</source>
            <translation>alles, was nach dem gewünschten Ende noch gekommen wäre</translation>
        </message>
        <message>
            <source>along the surface</source>
            <translation>tangential</translation>
        </message>
        <message>
            <source>amplifier's lag, as it stands in the delay</source>
            <translation>Verzug des Verstärkers, wie er in der Verzögerung steht</translation>
        </message>
        <message>
            <source>another one for each run</source>
            <translation>ein anderer für jeden Lauf</translation>
        </message>
        <message>
            <source>as before</source>
            <translation>wie zuvor</translation>
        </message>
        <message>
            <source>as you chose</source>
            <translation>wie von Ihnen gewählt</translation>
        </message>
        <message>
            <source>at</source>
            <translation>bei</translation>
        </message>
        <message>
            <source>at limit</source>
            <translation>am Limit</translation>
        </message>
        <message>
            <source>at −%1 s</source>
            <translation>bei −%1 s</translation>
        </message>
        <message>
            <source>beginning a new scene</source>
            <translation>dem Anlegen einer neuen Szene</translation>
        </message>
        <message>
            <source>being sampled</source>
            <translation>wird abgetastet</translation>
        </message>
        <message>
            <source>ceiling</source>
            <translation>Grenze</translation>
        </message>
        <message>
            <source>choose what to plot</source>
            <translation>wählen, was gezeichnet wird</translation>
        </message>
        <message>
            <source>closing</source>
            <translation>dem Schließen</translation>
        </message>
        <message>
            <source>contact</source>
            <translation>Kontakt</translation>
        </message>
        <message>
            <source>contacts</source>
            <translation>Kontakte</translation>
        </message>
        <message>
            <source>damping along %1</source>
            <translation>Dämpfung entlang %1</translation>
        </message>
        <message>
            <source>delay from command to force along %1</source>
            <translation>Verzögerung vom Befehl zur Kraft entlang %1</translation>
        </message>
        <message>
            <source>device %1</source>
            <translation>Gerät %1</translation>
        </message>
        <message>
            <source>device -%1</source>
            <translation>Gerät -%1</translation>
        </message>
        <message>
            <source>device limit %1</source>
            <translation>Gerätegrenze %1</translation>
        </message>
        <message>
            <source>device limit %1, above ↑</source>
            <translation>Gerätegrenze %1, darüber ↑</translation>
        </message>
        <message>
            <source>done</source>
            <translation>fertig</translation>
        </message>
        <message>
            <source>dry friction along %1</source>
            <translation>trockene Reibung entlang %1</translation>
        </message>
        <message>
            <source>dynamic</source>
            <translation>Gleitreibung</translation>
        </message>
        <message>
            <source>failed</source>
            <translation>fehlgeschlagen</translation>
        </message>
        <message>
            <source>felt</source>
            <translation>gefühlt</translation>
        </message>
        <message>
            <source>felt alone</source>
            <translation>allein gefühlt</translation>
        </message>
        <message>
            <source>finger</source>
            <translation>Finger</translation>
        </message>
        <message>
            <source>finger to proxy</source>
            <translation>Finger zu Proxy</translation>
        </message>
        <message>
            <source>folded</source>
            <translation>zugeklappt</translation>
        </message>
        <message>
            <source>force</source>
            <translation>Kraft</translation>
        </message>
        <message>
            <source>force along y to the force that is asked for</source>
            <translation>Kraft entlang y zur verlangten Kraft</translation>
        </message>
        <message>
            <source>force that the model does not explain along %1</source>
            <translation>Kraft, die das Modell nicht erklärt, entlang %1</translation>
        </message>
        <message>
            <source>forces off</source>
            <translation>Kräfte aus</translation>
        </message>
        <message>
            <source>forces on</source>
            <translation>Kräfte an</translation>
        </message>
        <message>
            <source>forces on · %1</source>
            <translation>Kräfte an · %1</translation>
        </message>
        <message>
            <source>free</source>
            <translation>frei</translation>
        </message>
        <message>
            <source>from above</source>
            <translation>von oben</translation>
        </message>
        <message>
            <source>front</source>
            <translation>vorn</translation>
        </message>
        <message>
            <source>full force</source>
            <translation>volle Kraft</translation>
        </message>
        <message>
            <source>guessed</source>
            <translation>geschätzt</translation>
        </message>
        <message>
            <source>guessed by the size of before</source>
            <translation>nach der Größe von zuvor geschätzt</translation>
        </message>
        <message>
            <source>hidden</source>
            <translation>ausgeblendet</translation>
        </message>
        <message>
            <source>hide or show all panels</source>
            <translation>alle Bereiche aus- oder einblenden</translation>
        </message>
        <message>
            <source>hinge</source>
            <translation>Scharnier</translation>
        </message>
        <message>
            <source>https://... or a DOI</source>
            <translation>https://... oder eine DOI</translation>
        </message>
        <message>
            <source>in a recording: play or pause, a hundredth of a second back or on, faster or slower</source>
            <translation>in einer Aufnahme: abspielen oder anhalten, eine Hundertstelsekunde zurück oder weiter, schneller oder langsamer</translation>
        </message>
        <message>
            <source>in a study: go on; each answer names its key, R feels again, Esc asks whether to end</source>
            <translation>in einer Studie: weiter; jede Antwort nennt ihre Taste, R fühlt noch einmal, Esc fragt, ob beendet werden soll</translation>
        </message>
        <message>
            <source>in the list of layers: remove, duplicate, move</source>
            <translation>in der Liste der Ebenen: entfernen, duplizieren, verschieben</translation>
        </message>
        <message>
            <source>in the list of layers: switch on or off, solo, rename</source>
            <translation>in der Liste der Ebenen: ein- oder ausschalten, Solo, umbenennen</translation>
        </message>
        <message>
            <source>is being read</source>
            <translation>wird gelesen</translation>
        </message>
        <message>
            <source>it does not run</source>
            <translation>es läuft nicht</translation>
        </message>
        <message>
            <source>kinetic</source>
            <translation>kinetisch</translation>
        </message>
        <message>
            <source>largest  %1 N</source>
            <translation>größte  %1 N</translation>
        </message>
        <message>
            <source>last %1 s</source>
            <translation>letzte %1 s</translation>
        </message>
        <message>
            <source>late</source>
            <translation>spät</translation>
        </message>
        <message>
            <source>least damping</source>
            <translation>kleinste Dämpfung</translation>
        </message>
        <message>
            <source>least dry friction</source>
            <translation>kleinste trockene Reibung</translation>
        </message>
        <message>
            <source>limited by a servo that comes late</source>
            <translation>begrenzt durch einen Servo, der zu spät kommt</translation>
        </message>
        <message>
            <source>limited by an oscillation that was seen</source>
            <translation>begrenzt durch eine erkannte Schwingung</translation>
        </message>
        <message>
            <source>limited by the damping of device and hand</source>
            <translation>begrenzt durch die Dämpfung von Gerät und Hand</translation>
        </message>
        <message>
            <source>limited by the damping of the surface</source>
            <translation>begrenzt durch die Dämpfung der Oberfläche</translation>
        </message>
        <message>
            <source>limited by the maker's figure</source>
            <translation>begrenzt durch die Angabe des Herstellers</translation>
        </message>
        <message>
            <source>limited by the resolution of the device</source>
            <translation>begrenzt durch die Auflösung des Geräts</translation>
        </message>
        <message>
            <source>limited by what a hand bears</source>
            <translation>begrenzt durch das, was eine Hand aushält</translation>
        </message>
        <message>
            <source>locked</source>
            <translation>gesperrt</translation>
        </message>
        <message>
            <source>longest delay, with the amplifier's lag</source>
            <translation>längste Verzögerung, mit dem Verzug des Verstärkers</translation>
        </message>
        <message>
            <source>longest time between two readings</source>
            <translation>längste Zeit zwischen zwei Messwerten</translation>
        </message>
        <message>
            <source>look from a camera that is kept, in the order of View &gt; Camera &gt; Kept cameras</source>
            <translation>durch eine gespeicherte Kamera blicken, in der Reihenfolge von Ansicht &gt; Kamera &gt; Gespeicherte Kameras</translation>
        </message>
        <message>
            <source>made by the surface, 0 or less is passive</source>
            <translation>von der Oberfläche erzeugt, 0 oder weniger ist passiv</translation>
        </message>
        <message>
            <source>mass, damping, friction and delay</source>
            <translation>Masse, Dämpfung, Reibung und Verzögerung</translation>
        </message>
        <message>
            <source>mass, damping, friction and delay along %1: it hardly moved, or something held it</source>
            <translation>Masse, Dämpfung, Reibung und Verzögerung entlang %1: Es bewegte sich kaum, oder etwas hielt es fest</translation>
        </message>
        <message>
            <source>mass, damping, friction and delay: no spring can hold the handle</source>
            <translation>Masse, Dämpfung, Reibung und Verzögerung: Keine Feder kann den Griff halten</translation>
        </message>
        <message>
            <source>median time between two readings</source>
            <translation>mittlere Zeit zwischen zwei Messwerten (Median)</translation>
        </message>
        <message>
            <source>mixed</source>
            <translation>gemischt</translation>
        </message>
        <message>
            <source>more than %1 µs</source>
            <translation>mehr als %1 µs</translation>
        </message>
        <message>
            <source>more than 0.1 % &gt; %1</source>
            <translation>mehr als 0.1 % &gt; %1</translation>
        </message>
        <message>
            <source>move it in the plane of the camera</source>
            <translation>ihn in der Kameraebene bewegen</translation>
        </message>
        <message>
            <source>move the finger along the view</source>
            <translation>den Finger entlang der Blickrichtung bewegen</translation>
        </message>
        <message>
            <source>move, turn, scale the selected objects with the mouse, or by a number that is typed; X, Y, Z keep to an axis, a click or Enter ends it</source>
            <translation>die gewählten Objekte mit der Maus oder durch eine getippte Zahl verschieben, drehen, skalieren; X, Y, Z bleiben auf einer Achse, ein Klick oder Eingabe beendet es</translation>
        </message>
        <message>
            <source>moves by its keys</source>
            <translation>bewegt sich nach Keyframes</translation>
        </message>
        <message>
            <source>moving mass along %1</source>
            <translation>bewegte Masse entlang %1</translation>
        </message>
        <message>
            <source>new readings</source>
            <translation>neue Messwerte</translation>
        </message>
        <message>
            <source>no source given</source>
            <translation>keine Quelle angegeben</translation>
        </message>
        <message>
            <source>nobody edits</source>
            <translation>niemand bearbeitet</translation>
        </message>
        <message>
            <source>noise of the position at rest</source>
            <translation>Rauschen der Position in Ruhe</translation>
        </message>
        <message>
            <source>none</source>
            <translation>keine</translation>
        </message>
        <message>
            <source>normal</source>
            <translation>normal</translation>
        </message>
        <message>
            <source>not alone</source>
            <translation>nicht allein</translation>
        </message>
        <message>
            <source>not felt</source>
            <translation>nicht gefühlt</translation>
        </message>
        <message>
            <source>not locked</source>
            <translation>nicht gesperrt</translation>
        </message>
        <message>
            <source>not running</source>
            <translation>läuft nicht</translation>
        </message>
        <message>
            <source>not there any more</source>
            <translation>nicht mehr da</translation>
        </message>
        <message>
            <source>nothing</source>
            <translation>nichts</translation>
        </message>
        <message>
            <source>nothing yet</source>
            <translation>noch nichts</translation>
        </message>
        <message>
            <source>now</source>
            <translation>jetzt</translation>
        </message>
        <message>
            <source>nudge the finger</source>
            <translation>den Finger ein wenig bewegen</translation>
        </message>
        <message>
            <source>of %1 N</source>
            <translation>von %1 N</translation>
        </message>
        <message>
            <source>of facets and of force shading</source>
            <translation>die von Facetten und Kraft-Shading</translation>
        </message>
        <message>
            <source>of its springs, motor, friction and stops</source>
            <translation>von Federn, Motor, Reibung und Anschlägen</translation>
        </message>
        <message>
            <source>of the selected body</source>
            <translation>des gewählten Körpers</translation>
        </message>
        <message>
            <source>of the selected body's joint</source>
            <translation>des Gelenks des gewählten Körpers</translation>
        </message>
        <message>
            <source>off</source>
            <translation>aus</translation>
        </message>
        <message>
            <source>on</source>
            <translation>an</translation>
        </message>
        <message>
            <source>on %1</source>
            <translation>auf %1</translation>
        </message>
        <message>
            <source>on %1 surfaces</source>
            <translation>auf %1 Oberflächen</translation>
        </message>
        <message>
            <source>opening %1</source>
            <translation>dem Öffnen von %1</translation>
        </message>
        <message>
            <source>or after so many edits</source>
            <translation>oder nach so vielen Änderungen</translation>
        </message>
        <message>
            <source>or drop files on this window: OBJ, PLY, STL, OFF, glTF, X3D, FBX, DAE, 3DS, 3MF</source>
            <translation>oder Dateien auf diesem Fenster ablegen: OBJ, PLY, STL, OFF, glTF, X3D, FBX, DAE, 3DS, 3MF</translation>
        </message>
        <message>
            <source>orbit; with Shift pan</source>
            <translation>umkreisen; mit Umschalt verschieben</translation>
        </message>
        <message>
            <source>other</source>
            <translation>anderes</translation>
        </message>
        <message>
            <source>overridden at your own risk</source>
            <translation>auf eigenes Risiko aufgehoben</translation>
        </message>
        <message>
            <source>paint; with Ctrl take away, with Shift smooth, Esc gives the stroke up</source>
            <translation>malen; mit Strg wegnehmen, mit Umschalt glätten, Esc bricht den Strich ab</translation>
        </message>
        <message>
            <source>path</source>
            <translation>Bahn</translation>
        </message>
        <message>
            <source>paused</source>
            <translation>angehalten</translation>
        </message>
        <message>
            <source>plays a finger path: tactum touch SCENE --path FINGER.csv</source>
            <translation>spielt einen Fingerweg: tactum touch SCENE --path FINGER.csv</translation>
        </message>
        <message>
            <source>potential</source>
            <translation>potenziell</translation>
        </message>
        <message>
            <source>press the finger into the surface and stroke it (touch tool)</source>
            <translation>den Finger in die Oberfläche drücken und darüber streichen (Werkzeug Berühren)</translation>
        </message>
        <message>
            <source>proxy</source>
            <translation>Proxy</translation>
        </message>
        <message>
            <source>proxy %1</source>
            <translation>Proxy %1</translation>
        </message>
        <message>
            <source>proxy %1  %2 µs</source>
            <translation>Proxy %1  %2 µs</translation>
        </message>
        <message>
            <source>questions: "%1" begins with no kind; write it as in the examples</source>
            <translation>Fragen: "%1" beginnt mit keiner Art; wie in den Beispielen schreiben</translation>
        </message>
        <message>
            <source>recorded</source>
            <translation>aufgenommen</translation>
        </message>
        <message>
            <source>recovering a scene</source>
            <translation>dem Wiederherstellen einer Szene</translation>
        </message>
        <message>
            <source>resolution of the position</source>
            <translation>Auflösung der Position</translation>
        </message>
        <message>
            <source>rms  %1 N</source>
            <translation>eff.  %1 N</translation>
        </message>
        <message>
            <source>scale of the position along %1</source>
            <translation>Maßstab der Position entlang %1</translation>
        </message>
        <message>
            <source>scene of %1</source>
            <translation>Szene von %1</translation>
        </message>
        <message>
            <source>select; with Shift more, with Ctrl less, Esc gives the stroke up</source>
            <translation>auswählen; mit Umschalt mehr, mit Strg weniger, Esc bricht den Strich ab</translation>
        </message>
        <message>
            <source>servo</source>
            <translation>Servo</translation>
        </message>
        <message>
            <source>servo %1</source>
            <translation>Servo %1</translation>
        </message>
        <message>
            <source>servo %1 ±%2 µs</source>
            <translation>Servo %1 ±%2 µs</translation>
        </message>
        <message>
            <source>slider</source>
            <translation>Schiene</translation>
        </message>
        <message>
            <source>slip</source>
            <translation>gleitet</translation>
        </message>
        <message>
            <source>slip</source>
            <comment>the contact</comment>
            <translation>gleitet</translation>
        </message>
        <message>
            <source>slipping</source>
            <translation>gleitet</translation>
        </message>
        <message>
            <source>source</source>
            <translation>Quelle</translation>
        </message>
        <message>
            <source>stands still</source>
            <translation>steht still</translation>
        </message>
        <message>
            <source>static</source>
            <translation>Haftreibung</translation>
        </message>
        <message>
            <source>stick</source>
            <translation>haftet</translation>
        </message>
        <message>
            <source>stick</source>
            <comment>the contact</comment>
            <translation>haftet</translation>
        </message>
        <message>
            <source>tangential by normal</source>
            <translation>tangential durch normal</translation>
        </message>
        <message>
            <source>texture</source>
            <translation>Textur</translation>
        </message>
        <message>
            <source>the %1 nearest of %2</source>
            <translation>die %1 nächsten von %2</translation>
        </message>
        <message>
            <source>the button was let go</source>
            <translation>die Taste wurde losgelassen</translation>
        </message>
        <message>
            <source>the buttons</source>
            <translation>die Tasten</translation>
        </message>
        <message>
            <source>the clutch is held</source>
            <translation>die Kupplung ist gehalten</translation>
        </message>
        <message>
            <source>the device was lost</source>
            <translation>das Gerät ging verloren</translation>
        </message>
        <message>
            <source>the device watchdog died</source>
            <translation>der Geräte-Watchdog ist ausgefallen</translation>
        </message>
        <message>
            <source>the device's stop button</source>
            <translation>die Stopptaste des Geräts</translation>
        </message>
        <message>
            <source>the finger follows the mouse until a click or Esc; with the select tool: move the layer's mapping</source>
            <translation>der Finger folgt der Maus bis zu einem Klick oder Esc; mit dem Werkzeug Auswählen: die Abbildung der Ebene verschieben</translation>
        </message>
        <message>
            <source>the finger was too fast</source>
            <translation>der Finger war zu schnell</translation>
        </message>
        <message>
            <source>the force comes back</source>
            <translation>die Kraft kommt zurück</translation>
        </message>
        <message>
            <source>the force jumped</source>
            <translation>die Kraft sprang</translation>
        </message>
        <message>
            <source>the force waits until it is small</source>
            <translation>die Kraft wartet, bis sie klein ist</translation>
        </message>
        <message>
            <source>the force was no number</source>
            <translation>die Kraft war keine Zahl</translation>
        </message>
        <message>
            <source>the grip seems lighter than chosen under Device &gt; Live</source>
            <translation>der Griff wird offenbar lockerer gehalten als unter Gerät &gt; Live gewählt</translation>
        </message>
        <message>
            <source>the motors' directions, and what rests on them</source>
            <translation>die Richtungen der Motoren, und was darauf beruht</translation>
        </message>
        <message>
            <source>the motors' directions: the readings do not say where it goes</source>
            <translation>die Richtungen der Motoren: Die Messwerte sagen nicht, wohin es geht</translation>
        </message>
        <message>
            <source>the mouse moves it in the window; 3 degrees of freedom, 1 kHz</source>
            <translation>die Maus bewegt sie im Fenster; 3 Freiheitsgrade, 1 kHz</translation>
        </message>
        <message>
            <source>the proxy loop did not answer</source>
            <translation>die Proxyschleife antwortete nicht</translation>
        </message>
        <message>
            <source>the ruler along %1</source>
            <translation>das Lineal entlang %1</translation>
        </message>
        <message>
            <source>the servo or the device stood still</source>
            <translation>der Servo oder das Gerät stand still</translation>
        </message>
        <message>
            <source>the weight of a known mass</source>
            <translation>das Gewicht einer bekannten Masse</translation>
        </message>
        <message>
            <source>the weight of a known mass, which must be from 5 to %1 g</source>
            <translation>das Gewicht einer bekannten Masse, die 5 bis %1 g haben muss</translation>
        </message>
        <message>
            <source>the weight of a known mass: no spring can hold the handle</source>
            <translation>das Gewicht einer bekannten Masse: Keine Feder kann den Griff halten</translation>
        </message>
        <message>
            <source>those of force shading</source>
            <translation>die des Kraft-Shadings</translation>
        </message>
        <message>
            <source>those of the facets</source>
            <translation>die der Facetten</translation>
        </message>
        <message>
            <source>ticks</source>
            <translation>Takte</translation>
        </message>
        <message>
            <source>to the right</source>
            <translation>nach rechts</translation>
        </message>
        <message>
            <source>today at %1</source>
            <translation>heute um %1</translation>
        </message>
        <message>
            <source>too fine for this mesh and left out: %1 %</source>
            <translation>zu fein für dieses Netz und ausgelassen: %1 %</translation>
        </message>
        <message>
            <source>toward you</source>
            <translation>zu Ihnen hin</translation>
        </message>
        <message>
            <source>typical; tables disagree. %1</source>
            <translation>typisch; Tabellen weichen ab. %1</translation>
        </message>
        <message>
            <source>unfolded</source>
            <translation>aufgeklappt</translation>
        </message>
        <message>
            <source>until the participant goes on</source>
            <translation>bis die Person weitergeht</translation>
        </message>
        <message>
            <source>up is</source>
            <translation>oben ist</translation>
        </message>
        <message>
            <source>upwards</source>
            <translation>nach oben</translation>
        </message>
        <message>
            <source>visible</source>
            <translation>sichtbar</translation>
        </message>
        <message>
            <source>what can be done with the object there, or with the scene</source>
            <translation>was mit dem Objekt dort oder mit der Szene getan werden kann</translation>
        </message>
        <message>
            <source>what stands still</source>
            <translation>was stillsteht</translation>
        </message>
        <message>
            <source>yesterday at %1</source>
            <translation>gestern um %1</translation>
        </message>
        <message>
            <source>you edit</source>
            <translation>Sie bearbeiten</translation>
        </message>
        <message>
            <source>zoom to the cursor</source>
            <translation>auf den Mauszeiger zoomen</translation>
        </message>
        <message>
            <source>“%1” is not %2</source>
            <translation>„%1“ ist %2</translation>
        </message>
        <message numerus="yes">
            <source>⚠ %n step(s) are not as recorded</source>
            <translation>
                <numerusform>⚠ %n Schritt nicht wie aufgenommen</numerusform>
                <numerusform>⚠ %n Schritte nicht wie aufgenommen</numerusform>
            </translation>
        </message>
        <message>
            <source>✓ the same bits as recorded</source>
            <translation>✓ dieselben Bits wie aufgenommen</translation>
        </message>
    </context>
</TS>
