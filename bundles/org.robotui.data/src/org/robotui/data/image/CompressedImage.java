package org.robotui.data.image;

import org.robotui.data.FrameId;
import org.robotui.data.array.Bytes;

/**
 * A picture in a compressed format.
 *
 * @param frame optical frame of the camera
 * @param format as the robot names it, for example {@code jpeg} or {@code png}
 * @param data the file's bytes
 */
public record CompressedImage(FrameId frame, String format, Bytes data) implements Image {}
