package org.robotui.yarp;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.BottleText;
import org.robotui.yarp.bottle.YarpValue;
import org.robotui.yarp.image.YarpImage;
import org.robotui.yarp.name.YarpAddress;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/** Everything that was recorded is read, and written as it was. */
class RecordedBottlesTest {

  static Stream<String> connections() {
    return Stream.concat(YarpCaptures.FROM_ROBOT.stream(), YarpCaptures.TO_ROBOT.stream());
  }

  @ParameterizedTest
  @MethodSource("connections")
  void messages_are_written_as_they_were(String connection) throws IOException {
    byte[] whole = YarpCaptures.bytes(connection + ".c2s.bin");
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    written.writeBytes(YarpFraming.bytes(YarpFraming.readHeader(new ByteArrayInputStream(whole))));
    for (YarpMessage message : YarpCaptures.messages(connection)) {
      byte[] data = message.data().length == 0 ? message.data() : BottleCodec.bytes(BottleCodec.read(message.data()));
      written.writeBytes(
          YarpFraming.bytes(new YarpMessage(message.command(), data, message.blocks(), message.replyLength())));
    }
    assertArrayEquals(whole, written.toByteArray());
  }

  @ParameterizedTest
  @MethodSource("connections")
  void answers_are_written_as_they_were(String connection) throws IOException {
    byte[] whole = YarpCaptures.bytes(connection + ".s2c.bin");
    ByteArrayInputStream in = new ByteArrayInputStream(whole);
    ByteArrayOutputStream written = new ByteArrayOutputStream();
    while (in.available() > 0 && !isPlainText(whole, written.size())) {
      int first = YarpFraming.int32(in);
      written.writeBytes(YarpFraming.isMark(first) ? YarpFraming.mark(YarpFraming.readMark(first, in))
          : BottleCodec.bytes(BottleCodec.read(first, in)));
    }
    assertArrayEquals(Arrays.copyOf(whole, written.size()), written.toByteArray());
    assertTrue(in.available() == 0 || connection.equals("a_ns_tcp"), "all of it is read");
  }

  /** What a name server answers to a registration by tcp is text without any length. */
  private static boolean isPlainText(byte[] whole, int at) {
    return whole[at] >= 'a' || whole[at] == '*';
  }

  @Test
  void lines_of_name_servers_are_written_as_they_were() {
    List<String> lines = YarpCaptures.lines("a_ns_list.s2c.bin").stream().filter(l -> !l.startsWith("***")).toList();
    assertEquals(26, lines.size());
    for (String line : lines) {
      assertEquals(line, YarpAddress.parse(line).orElseThrow().line());
    }
  }

  @ParameterizedTest
  @ValueSource(ints = {Float.SIZE, Double.SIZE})
  void lists_of_fractions_that_were_read_are_those_that_were_made(int bits) throws IOException {
    List<YarpValue> made = Stream.of(0.5, -3.0, Double.NaN, Double.NEGATIVE_INFINITY, 0.0)
        .map(value -> (YarpValue) new YarpValue.Real(value, bits)).toList();

    Bottle read = BottleCodec.read(BottleCodec.bytes(Bottle.of(made)));

    assertEquals(Bottle.of(made), read);
    assertEquals(Bottle.of(made).hashCode(), read.hashCode());
    assertEquals(made, List.copyOf(read.values()));
    assertArrayEquals(new double[]{0.5, -3, Double.NaN, Double.NEGATIVE_INFINITY, 0}, read.numbers());
    read.numbers()[0] = 7;
    assertEquals(0.5, read.get(0).number(), "nobody can change it");
    assertThrows(UnsupportedOperationException.class, () -> read.values().clear());
  }

  @Test
  void text_of_bottles_is_read_and_written() throws IOException {
    List<String> seen = new ArrayList<>();
    for (String file : YarpCaptures.texts()) {
      for (String line : YarpCaptures.lines(file + ".s2c.bin")) {
        if (line.startsWith("[") || line.startsWith("0 ") || line.startsWith("(")) {
          Bottle bottle = BottleText.parse(line);
          assertEquals(bottle, BottleText.parse(BottleText.format(bottle)), line);
          seen.add(line);
        }
      }
    }
    assertTrue(seen.size() > 15, () -> seen.toString());
    Bottle axes = BottleText.parse("[is] axes 3 [tsta] 0 1795236455.28167438507 [ok]");
    assertEquals(3, axes.get(2).number());
    assertEquals(YarpValue.Vocab.of("ok"), axes.get(6));
  }

  @Test
  void known_values_are_found() throws IOException {
    Bottle scan = YarpCaptures.bottles("b_to_ui_laser_tcp").getFirst();
    assertEquals(360, scan.get(4).items().size());
    assertEquals(0.7767214775085449, scan.get(4).items().get(0).number());
    assertEquals(53, YarpCaptures.messages("b_to_ui_laser_tcp").getFirst().stamp().orElseThrow().sequence());
    Bottle imu = YarpCaptures.bottles("b_to_ui_imu_tcp").getFirst();
    assertEquals(10, imu.size());
    assertArrayEquals(new double[]{167, 167, 167}, imu.get(0).items().get(0).items().get(0).items().numbers());
    Bottle board = YarpCaptures.bottles("b_to_ui_read_tcp3").getLast();
    assertArrayEquals(new double[]{20, 5, 0}, board.get(0).items().numbers());
    assertEquals("vel", new YarpValue.Vocab((int) board.get(18).items().get(1).number()).word());
    YarpImage picture = YarpImage.read(YarpCaptures.bottles("b_to_ui_cam_tcp").getFirst());
    assertEquals("rgb 32 24 96",
        picture.pixels() + " " + picture.width() + " " + picture.height() + " " + picture.step());
    assertEquals(YarpCaptures.bottles("b_to_ui_cam_tcp").getFirst().values().subList(0, 2),
        picture.toBottle().values().subList(0, 2));
    Bottle command = YarpCaptures.bottles("b_board_command_i_tcp").getFirst();
    assertEquals("vmos", command.get(0).items().get(0).text());
    assertArrayEquals(new double[]{1, 2, 3}, command.get(1).items().numbers());
  }

  /** What a client of ours writes has the bytes of a genuine one. */
  @Test
  void what_we_make_has_the_bytes_of_yarp() throws IOException {
    YarpMessage asked = YarpCaptures.messages("b_board_rpc_i_tcp3").getFirst();
    byte[] made = YarpFraming.bytes(YarpMessage.of(BottleCodec.bytes(Bottle.of("get", "axes"))));
    assertArrayEquals(YarpFraming.bytes(asked), made);
    YarpMessage last = YarpCaptures.messages("b_board_rpc_i_tcp3").getLast();
    assertArrayEquals(YarpFraming.bytes(last),
        YarpFraming.bytes(new YarpMessage("q", new byte[0], YarpMessage.quit().blocks(), 0)));
    byte[] picture = YarpCaptures.messages("b_to_ui_cam_tcp").getFirst().data();
    assertArrayEquals(picture, BottleCodec.bytes(
        YarpImage.read(YarpCaptures.bottles("b_to_ui_cam_tcp").getFirst()).toBottle()));
  }
}
