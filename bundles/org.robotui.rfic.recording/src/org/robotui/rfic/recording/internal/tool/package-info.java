/** What prints, copies and exports recordings on the command line. */
package org.robotui.rfic.recording.internal.tool;
