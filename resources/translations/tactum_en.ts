<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en">
    <context>
        <name>Tactum</name>
        <message numerus="yes">
            <source>%1: %n tick(s), %2</source>
            <translation>
                <numerusform>%1: %n tick, %2</numerusform>
                <numerusform>%1: %n ticks, %2</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n picture(s) were left out, for the encoder could not follow; a smaller size takes less.</source>
            <translation>
                <numerusform>%n picture was left out, for the encoder could not follow; a smaller size takes less.</numerusform>
                <numerusform>%n pictures were left out, for the encoder could not follow; a smaller size takes less.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n question(s) after each</source>
            <translation>
                <numerusform>%n question after each</numerusform>
                <numerusform>%n questions after each</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>%n trial(s)</source>
            <translation>
                <numerusform>%n trial</numerusform>
                <numerusform>%n trials</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>At most %n trial(s)</source>
            <translation>
                <numerusform>At most %n trial</numerusform>
                <numerusform>At most %n trials</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Held by %n joint(s) of another kind, which stay as they are in the file.</source>
            <translation>
                <numerusform>Held by %n joint of another kind, which stays as it is in the file.</numerusform>
                <numerusform>Held by %n joints of another kind, which stay as they are in the file.</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>Split off %n triangle(s)</source>
            <translation>
                <numerusform>Split off %n triangle</numerusform>
                <numerusform>Split off %n triangles</numerusform>
            </translation>
        </message>
        <message numerus="yes">
            <source>⚠ %n step(s) are not as recorded</source>
            <translation>
                <numerusform>⚠ %n step is not as recorded</numerusform>
                <numerusform>⚠ %n steps are not as recorded</numerusform>
            </translation>
        </message>
    </context>
</TS>
