/** The one time of all recordings that are open: what moves it, and the place of each recording on it. */
package org.robotui.rfic.recording.internal.time;
