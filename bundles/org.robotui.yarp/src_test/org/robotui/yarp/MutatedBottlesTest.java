package org.robotui.yarp;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayInputStream;
import java.io.EOFException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.testkit.ByteMutator;
import org.robotui.testkit.Effort;
import org.robotui.yarp.bottle.Bottle;
import org.robotui.yarp.bottle.BottleCodec;
import org.robotui.yarp.bottle.BottleText;
import org.robotui.yarp.bottle.YarpFormatException;
import org.robotui.yarp.image.YarpImage;
import org.robotui.yarp.name.YarpAddress;
import org.robotui.yarp.wire.YarpFraming;
import org.robotui.yarp.wire.YarpMessage;

/** Damaged recordings lead to the declared exceptions only, quickly and without large allocations. */
class MutatedBottlesTest {
  private static final int ROUNDS = 400;
  private static final Duration LONG = Duration.ofSeconds(20);

  private final ByteMutator mutator = new ByteMutator(2026 + Effort.seed());

  @ParameterizedTest
  @ValueSource(strings = {"b_to_ui_imu_tcp", "b_to_ui_stateExt_tcp", "b_board_rpc_i_tcp", "b_to_ui_cam_tcp"})
  @Timeout(1_200)
  void damaged_bottles_are_refused_or_read(String connection) {
    List<YarpMessage> messages = YarpCaptures.messages(connection);
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      byte[] data = messages.get(mutator.random().nextInt(messages.size())).data();
      refused += reads(mutator.mutate(data)) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static boolean reads(byte[] data) {
    try {
      Bottle bottle = BottleCodec.read(data);
      assertTrue(bottle.equals(BottleCodec.read(BottleCodec.bytes(bottle))) || bottle.toString().contains("nan"));
      if (YarpImage.isImage(bottle)) {
        YarpImage.read(bottle);
      }
      return true;
    } catch (YarpFormatException e) {
      return false;
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"b_to_ui_state_tcp", "b_to_ui_laser_tcp", "a_ns_tcp", "b_board_rpc_i_tcp3"})
  @Timeout(1_200)
  void damaged_streams_end_with_an_error_or_their_end(String connection) throws IOException {
    byte[] whole = YarpCaptures.bytes(connection + ".c2s.bin");
    int refused = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      refused += readsToTheEnd(new ByteArrayInputStream(mutator.mutate(whole))) ? 0 : 1;
    }
    assertTrue(refused > 0, "some damages matter");
  }

  private static boolean readsToTheEnd(ByteArrayInputStream in) throws IOException {
    try {
      YarpFraming.readHeader(in);
      while (in.available() > 0) {
        YarpFraming.read(in).stamp();
      }
      return true;
    } catch (EOFException | YarpFormatException e) {
      return false;
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"a_board_rpc_i_text", "b_ns_query", "a_imu_rpc_o_text"})
  @Timeout(1_200)
  void damaged_text_is_refused_or_read(String connection) {
    byte[] whole = YarpCaptures.bytes(connection + ".s2c.bin");
    int read = 0;
    for (Effort effort = Effort.of(ROUNDS, LONG); effort.goesOn();) {
      String text = new String(mutator.mutate(whole), StandardCharsets.UTF_8);
      for (String line : text.lines().toList()) {
        read += parses(line) || YarpAddress.parse(line).isPresent() ? 1 : 0;
      }
    }
    assertTrue(read > 0, "some damages do not matter");
  }

  private static boolean parses(String line) {
    try {
      BottleText.format(BottleText.parse(line));
      return true;
    } catch (YarpFormatException e) {
      return false;
    }
  }
}
