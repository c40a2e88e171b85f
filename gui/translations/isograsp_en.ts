<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en" sourcelanguage="en">
<context>
    <name>LibraryPreview</name>
    <message numerus="yes">
        <source>%1 (%n time(s))</source>
        <translation>
            <numerusform>%1 (%n time)</numerusform>
            <numerusform>%1 (%n times)</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>ProtocolGuide</name>
    <message numerus="yes">
        <source>%1 and %n more</source>
        <translation>
            <numerusform>%1 and %n more</numerusform>
            <numerusform>%1 and %n more</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ExportPanel</name>
    <message numerus="yes">
        <source>%n trial(s) written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</source>
        <translation>
            <numerusform>%n trial written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</numerusform>
            <numerusform>%n trials written to &lt;a href=&quot;%1&quot;&gt;%2&lt;/a&gt;</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n file(s), below a new folder:</source>
        <translation>
            <numerusform>%n file, below a new folder:</numerusform>
            <numerusform>%n files, below a new folder:</numerusform>
        </translation>
    </message>
    <message numerus="yes">
        <source>%n patient(s) left out: not released for research.</source>
        <translation>
            <numerusform>%n patient left out: not released for research.</numerusform>
            <numerusform>%n patients left out: not released for research.</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ObjectSketch</name>
    <message numerus="yes">
        <source>The object in the plane of x and y, with %n target(s)</source>
        <translation>
            <numerusform>The object in the plane of x and y, with %n target</numerusform>
            <numerusform>The object in the plane of x and y, with %n targets</numerusform>
        </translation>
    </message>
</context>
<context>
    <name>isograsp::gui::ProtocolForm</name>
    <message numerus="yes">
        <source>Interrupted today after %n step(s). Go on where it stopped?</source>
        <translation>
            <numerusform>Interrupted today after %n step. Go on where it stopped?</numerusform>
            <numerusform>Interrupted today after %n steps. Go on where it stopped?</numerusform>
        </translation>
    </message>
</context>
</TS>
