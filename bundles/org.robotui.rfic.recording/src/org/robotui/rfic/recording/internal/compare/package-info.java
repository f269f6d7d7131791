/** How two runs differ: values, and the ways that robots went. */
package org.robotui.rfic.recording.internal.compare;
