/** One open recording as a robot: its topics, and what is delivered of them at which time. */
package org.robotui.rfic.recording.internal.session;
