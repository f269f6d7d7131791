package org.robotui.sim.internal.message;

import java.util.function.BiConsumer;
import java.util.function.BooleanSupplier;
import org.robotui.message.ros.sensor_msgs.CameraInfo;
import org.robotui.sim.internal.Rate;
import org.robotui.sim.internal.RobotState;
import org.robotui.sim.internal.camera.PictureWorker;

/** When a camera says what it is, always, and takes a picture, while somebody wants it. */
final class Shutter implements AutoCloseable {
  private final Rate rate;
  private final CameraMessages messages;
  private final MessageSink<CameraInfo> info;
  private final BooleanSupplier wanted;
  private final BiConsumer<RobotState, Stamp> take;
  private final PictureWorker darkroom;
  private long sequence;

  Shutter(String name, Rate rate, CameraMessages messages, MessageSink<CameraInfo> info, BooleanSupplier wanted,
      BiConsumer<RobotState, Stamp> take) {
    this.rate = rate;
    this.messages = messages;
    this.info = info;
    this.wanted = wanted;
    this.take = take;
    this.darkroom = new PictureWorker(name);
  }

  void press(long step, RobotState state, long nanos) {
    if (rate.isDue(step)) {
      Stamp stamp = new Stamp(++sequence, nanos);
      info.send(messages.info(stamp));
      if (wanted.getAsBoolean()) {
        darkroom.offer(() -> take.accept(state, stamp));
      }
    }
  }

  @Override
  public void close() {
    darkroom.close();
  }
}
