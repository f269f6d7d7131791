/** What scripts can do with the timeline. */
package org.robotui.rfic.recording.internal.script;
