/** Logs that are lines of text, as recordings: those of CARMEN's logger and of Player's driver writelog. */
package org.robotui.rfic.recording.internal.lines;
