/** When something was so in recordings: the conditions of alerts, asked of all of their time. */
package org.robotui.rfic.recording.internal.find;
