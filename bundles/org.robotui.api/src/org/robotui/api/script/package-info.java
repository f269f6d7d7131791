/**
 * Scripts: what a bundle contributes to their language, and how applications and views run them. Nothing here knows the
 * engine; values are plain.
 *
 * <p>A plain value is null, a Boolean, a Number, a String, a List of plain values, or a Map of plain values by String.
 * Functions may also give data of robots ({@link org.robotui.data.record.DynamicRecord}), which scripts see as maps,
 * and may be given functions of the script ({@link org.robotui.api.script.ScriptCallback}).
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.api.script;
