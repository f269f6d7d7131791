/** Traces of recordings, which are read whole, past and future, beside what is played. */
package org.robotui.uic.plot.internal.whole;
