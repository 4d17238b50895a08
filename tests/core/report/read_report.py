#!/usr/bin/python3
"""A report as another program reads it: its tables as JSON, and an error for what a page must not have."""
import base64
import html.parser
import json
import sys

VOID = {"meta", "img", "br", "link", "input", "hr"}
FORBIDDEN = {"script", "iframe", "object", "embed", "link", "form"}


class Report(html.parser.HTMLParser):
    def __init__(self):
        super().__init__()
        self.open, self.faults, self.tables, self.pictures, self.title = [], [], [], [], ""

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        if tag in FORBIDDEN or any(name.startswith("on") for name in values):
            self.faults.append(f"<{tag}> at {self.getpos()}")
        if tag == "img":
            self.picture(values)
        if tag == "table":
            self.tables.append([])
        if tag == "tr":
            self.tables[-1].append([])
        if tag in ("th", "td"):
            if tag == "th" and values.get("scope") not in ("col", "row"):
                self.faults.append(f"a header without scope at {self.getpos()}")
            self.tables[-1][-1].append("")
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.faults.append(f"</{tag}> closes nothing at {self.getpos()}")

    def handle_data(self, text):
        if self.open and self.open[-1] in ("th", "td"):
            self.tables[-1][-1][-1] += text
        if self.open and self.open[-1] == "title":
            self.title += text

    def picture(self, values):
        source = values.get("src", "")
        if not values.get("alt"):
            self.faults.append(f"a picture without words at {self.getpos()}")
        if not source.startswith("data:image/"):
            self.faults.append(f"a picture from elsewhere: {source[:60]}")
        kind, data = source[5:].split(";base64,")
        self.pictures.append({"kind": kind, "alt": values.get("alt", ""), "bytes": len(base64.b64decode(data, validate=True))})


report = Report()
report.feed(open(sys.argv[1], encoding="utf-8").read())
if report.open:
    report.faults.append("not closed: " + " ".join(report.open))
json.dump({"title": report.title, "faults": report.faults, "tables": report.tables, "pictures": report.pictures}, sys.stdout)
