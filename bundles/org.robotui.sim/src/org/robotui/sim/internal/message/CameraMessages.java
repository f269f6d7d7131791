package org.robotui.sim.internal.message;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.robotui.message.ros.sensor_msgs.CameraInfo;
import org.robotui.message.ros.sensor_msgs.CompressedImage;
import org.robotui.message.ros.sensor_msgs.Image;
import org.robotui.message.ros.sensor_msgs.RegionOfInterest;
import org.robotui.sim.internal.camera.Lens;

/** Messages of the camera. */
final class CameraMessages {
  private final Frames frames;
  private final Lens lens;

  CameraMessages(Frames frames, Lens lens) {
    this.frames = frames;
    this.lens = lens;
  }

  /** @param pixels of 0xrrggbb */
  Image raw(int[] pixels, Stamp stamp) {
    byte[] bytes = new byte[3 * pixels.length];
    for (int i = 0; i < pixels.length; i++) {
      bytes[3 * i] = (byte) (pixels[i] >> 16);
      bytes[3 * i + 1] = (byte) (pixels[i] >> 8);
      bytes[3 * i + 2] = (byte) pixels[i];
    }
    return new Image(
        stamp.header(frames.cameraOptical()), lens.height(), lens.width(), "rgb8", 0, 3L * lens.width(),
        ByteBuffer.wrap(bytes));
  }

  /** @param millimetres as unsigned numbers, zero where nothing was measured */
  Image depth(short[] millimetres, Stamp stamp) {
    ByteBuffer bytes = ByteBuffer.allocate(Short.BYTES * millimetres.length).order(ByteOrder.LITTLE_ENDIAN);
    bytes.asShortBuffer().put(millimetres);
    return new Image(stamp.header(frames.cameraOptical()), lens.height(), lens.width(), "16UC1", 0,
        (long) Short.BYTES * lens.width(), bytes);
  }

  CompressedImage compressed(byte[] jpeg, Stamp stamp) {
    return new CompressedImage(stamp.header(frames.cameraOptical()), "rgb8; jpeg compressed bgr8",
        ByteBuffer.wrap(jpeg));
  }

  CameraInfo info(Stamp stamp) {
    double f = lens.focalLength();
    double cx = lens.centreX() - 0.5;
    double cy = lens.centreY() - 0.5;
    return new CameraInfo(
        stamp.header(frames.cameraOptical()), lens.height(), lens.width(), "plumb_bob", new double[5],
        new double[]{f, 0, cx, 0, f, cy, 0, 0, 1},
        new double[]{1, 0, 0, 0, 1, 0, 0, 0, 1},
        new double[]{f, 0, cx, 0, 0, f, cy, 0, 0, 0, 1, 0},
        0, 0, new RegionOfInterest(0, 0, 0, 0, false));
  }
}
