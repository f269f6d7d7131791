package org.robotui.rtps;

import static org.junit.jupiter.api.Assertions.fail;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;

/** Strings as ROS sends them, what came of them, and waiting for it. */
final class Heard implements SampleListener {

  static final String TYPE = "std_msgs::msg::dds_::String_";
  static final ByteBuffer NOTHING = ByteBuffer.allocate(0);

  private final List<Sample> samples = new CopyOnWriteArrayList<>();

  @Override
  public void received(Sample sample) {
    samples.add(sample);
  }

  List<Sample> samples() {
    return List.copyOf(samples);
  }

  /** The texts, each up to its first space. */
  List<String> words() {
    return samples.stream().map(sample -> text(sample.payload()).split(" ", 2)[0]).toList();
  }

  static ByteBuffer string(String text) {
    byte[] utf = text.getBytes(StandardCharsets.UTF_8);
    ByteBuffer bytes = ByteBuffer.allocate(9 + utf.length).put(new byte[]{0, 1, 0, 0});
    return bytes.order(ByteOrder.LITTLE_ENDIAN).putInt(utf.length + 1).put(utf).put((byte) 0).flip();
  }

  static String text(ByteBuffer payload) {
    ByteOrder order = payload.get(payload.position() + 1) == 1 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN;
    ByteBuffer from = payload.order(order).position(payload.position() + 4);
    byte[] utf = new byte[from.getInt() - 1];
    from.get(utf);
    return new String(utf, StandardCharsets.UTF_8);
  }

  static void await(Duration most, BooleanSupplier condition, Supplier<String> what) throws InterruptedException {
    long deadline = System.nanoTime() + most.toNanos();
    while (!condition.getAsBoolean()) {
      if (System.nanoTime() > deadline) {
        fail("not within " + most + ": " + what.get());
      }
      Thread.sleep(5);
    }
  }
}
