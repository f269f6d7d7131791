/** Recordings of all formats, and how their messages are read. */
package org.robotui.rfic.recording.internal.file;
