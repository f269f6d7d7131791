/** Messages of recordings as tables and lines, for programs of others. */
package org.robotui.rfic.recording.internal.export;
