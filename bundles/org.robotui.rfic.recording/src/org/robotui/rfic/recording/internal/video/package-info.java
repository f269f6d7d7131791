/** Pictures of cameras as videos, by ffmpeg. */
package org.robotui.rfic.recording.internal.video;
