package org.robotui.ros.reconfigure;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.robotui.message.MessageException;
import org.robotui.message.MessageWriter;
import org.robotui.message.RecordCodec;
import org.robotui.ros.msgs.dynamic_reconfigure.BoolParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Config;
import org.robotui.ros.msgs.dynamic_reconfigure.ConfigDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.DoubleParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.Group;
import org.robotui.ros.msgs.dynamic_reconfigure.GroupState;
import org.robotui.ros.msgs.dynamic_reconfigure.IntParameter;
import org.robotui.ros.msgs.dynamic_reconfigure.ParamDescription;
import org.robotui.ros.msgs.dynamic_reconfigure.StrParameter;
import org.robotui.testkit.Effort;

/** Damaged descriptions are refused by the codec, or read as what they then say: nothing else is thrown. */
class DamagedDescriptionsTest {

  private static final int[] EVIL = {-1, Integer.MAX_VALUE, Integer.MIN_VALUE, 1 << 28, 1 << 16, 0};

  private final SplittableRandom random = new SplittableRandom(2026);

  private static byte[] description() {
    ParamDescription rate = new ParamDescription("rate", "int", 1, "how often",
        "{'enum': [{'name': 'Slow', 'value': 1, 'description': ''}], 'enum_description': 'how often'}");
    ParamDescription gain = new ParamDescription("gain", "double", 2, "how much", "");
    Config config = new Config(List.of(new BoolParameter("on", true)), List.of(new IntParameter("rate", 3)),
        List.of(new StrParameter("s", "t")),
        List.of(new DoubleParameter("gain", 0.5)), List.of(new GroupState("Default", true, 0, 0)));
    List<Group> groups =
        List.of(new Group("Default", "", List.of(rate, gain), 0, 0), new Group("Inner", "tab", List.of(rate), 0, 1));
    MessageWriter out = new MessageWriter();
    RecordCodec.of(ConfigDescription.class).encode(new ConfigDescription(groups, config, config, config), out);
    return out.toByteArray();
  }

  @Test
  @Timeout(600)
  void damagedDescriptionsAreRefusedOrRead() {
    int rounds = Effort.rounds(20_000);
    int refused = 0;
    for (int round = 0; round < rounds; round++) {
      refused += isRead(damage(description())) ? 0 : 1;
    }
    assertTrue(refused > rounds / 4 && refused < rounds, refused + " of " + rounds);
  }

  private byte[] damage(byte[] bytes) {
    switch (random.nextInt(4)) {
      case 0 -> {
        return Arrays.copyOf(bytes, random.nextInt(bytes.length + 20));
      }
      case 1 -> ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN)
          .putInt(random.nextInt(bytes.length - Integer.BYTES), EVIL[random.nextInt(EVIL.length)]);
      default -> {
        for (int i = 0; i < 4; i++) {
          bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
        }
      }
    }
    return bytes;
  }

  private static boolean isRead(byte[] bytes) {
    try {
      ConfigDescription message =
          RecordCodec.of(ConfigDescription.class).decode(ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN));
      ServerDescription read = Configs.description(message).orElseThrow();
      return read.parameters().size() <= 3 && Configs.values(message.dflt()).values().size() <= 4;
    } catch (MessageException e) {
      return false;
    }
  }
}
