/** How far the clocks of two recordings are apart, found out by what both recorded. */
package org.robotui.rfic.recording.internal.align;
