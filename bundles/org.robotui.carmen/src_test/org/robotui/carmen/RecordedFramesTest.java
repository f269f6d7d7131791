package org.robotui.carmen;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.robotui.carmen.CarmenCaptures.Told;
import org.robotui.carmen.message.IpcRecord;
import org.robotui.carmen.message.IpcValue;
import org.robotui.carmen.wire.IpcFrame;
import org.robotui.carmen.wire.IpcFraming;

/** Everything that was recorded is read, and written as it was. */
class RecordedFramesTest {

  static Stream<String> connections() {
    return Stream.concat(CarmenCaptures.TO_CENTRAL.stream(), CarmenCaptures.DIRECT.keySet().stream().sorted());
  }

  @ParameterizedTest
  @MethodSource("connections")
  void frames_are_written_as_they_were(String connection) {
    assertWritten(CarmenCaptures.fromModule(connection), CarmenCaptures.bytes(connection + ".c2s.bin"));
    assertWritten(CarmenCaptures.toModule(connection), CarmenCaptures.bytes(connection + ".s2c.bin"));
  }

  private static void assertWritten(List<IpcFrame> frames, byte[] whole) {
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    frames.forEach(frame -> written.writeBytes(IpcFraming.bytes(frame)));
    assertArrayEquals(Arrays.copyOfRange(whole, whole.length - written.size(), whole.length), written.toByteArray());
    assertTrue(whole.length - written.size() <= Integer.BYTES);
  }

  @ParameterizedTest
  @MethodSource("connections")
  void messages_are_written_as_they_were(String connection) throws IOException {
    for (Told told : CarmenCaptures.all(connection)) {
      IpcRecord record =
          told.bare() ? told.form().readBare(told.frame().body()) : told.form().read(told.frame().body());
      byte[] written = told.bare() ? told.form().writeBare(record, ByteOrder.LITTLE_ENDIAN)
          : told.form().write(record, ByteOrder.LITTLE_ENDIAN);
      assertEquals(told.frame().body(), ByteBuffer.wrap(written), () -> told.form().name() + " " + record);
      assertSwapped(told, record);
    }
  }

  /** The same in the order of bytes of other machines. */
  private static void assertSwapped(Told told, IpcRecord record) throws IOException {
    if (told.bare()) {
      return;
    }
    ByteBuffer swapped = ByteBuffer.wrap(told.form().write(record, ByteOrder.BIG_ENDIAN)).order(ByteOrder.BIG_ENDIAN);
    IpcRecord again = told.form().read(swapped);
    assertEquals(told.frame().body(), ByteBuffer.wrap(told.form().write(again, ByteOrder.LITTLE_ENDIAN)));
  }

  @ParameterizedTest
  @MethodSource("connections")
  void every_message_of_carmen_has_names(String connection) throws IOException {
    for (Told told : CarmenCaptures.all(connection)) {
      boolean numbered = !told.bare() && told.frame().body().hasRemaining()
          && told.form().fields().stream().anyMatch(f -> f.name().equals("field1"));
      assertTrue(!numbered && !(told.form().isEmpty() && told.frame().body().hasRemaining()),
          () -> told.form().name() + " has no names");
    }
  }

  @Test
  void known_values_are_found() throws IOException {
    List<Told> all = CarmenCaptures.all("base_client");
    IpcRecord odometry = last(all, "carmen_base_odometry");
    assertEquals(0.4128, odometry.number("x"), 1e-9);
    assertEquals("robot", odometry.text("host"));
    IpcRecord laser = last(all, "carmen_robot_frontlaser");
    assertEquals(181, laser.floats("range").length);
    assertEquals(81.0, laser.record("config").number("maximum_range"));
    IpcRecord truth = last(all, "carmen_simulator_truepos");
    assertEquals(30.400, truth.record("truepose").number("x"), 1e-3);
    assertEquals(0.41, all.stream().filter(t -> t.form().name().equals("carmen_param_respond_double"))
        .map(RecordedFramesTest::read).filter(r -> r.text("variable_name").equals("width")).findFirst().orElseThrow()
        .number("value"));
    IpcRecord sonar = last(CarmenCaptures.all("localize_client"), "carmen_base_sonar");
    assertEquals(7, sonar.doubles("range").length);
    assertTrue(
        sonar.field("sonar_offsets").orElseThrow() instanceof IpcValue.Items items && items.values().size() == 7);
  }

  private static IpcRecord last(List<Told> all, String name) {
    return read(all.stream().filter(t -> t.form().name().equals(name) && t.frame().body().hasRemaining())
        .reduce((a, b) -> b).orElseThrow());
  }

  private static IpcRecord read(Told told) {
    try {
      return told.form().read(told.frame().body());
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }
}
