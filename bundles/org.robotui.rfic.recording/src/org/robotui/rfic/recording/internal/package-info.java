/** Recordings that are played as if they were robots. */
package org.robotui.rfic.recording.internal;
