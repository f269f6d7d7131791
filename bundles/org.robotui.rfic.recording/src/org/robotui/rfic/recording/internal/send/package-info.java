/** Plays recordings into the frameworks that they are of, for programs of these frameworks. */
package org.robotui.rfic.recording.internal.send;
