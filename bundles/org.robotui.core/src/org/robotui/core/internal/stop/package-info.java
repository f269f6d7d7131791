/** The way to STOP that needs no window, and what is remembered of stops for the next start. */
package org.robotui.core.internal.stop;
