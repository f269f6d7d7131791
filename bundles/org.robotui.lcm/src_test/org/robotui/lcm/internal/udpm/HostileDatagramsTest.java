package org.robotui.lcm.internal.udpm;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.net.InetSocketAddress;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.robotui.lcm.LcmMessage;
import org.robotui.lcm.LcmOptions;
import org.robotui.lcm.Mutator;
import org.robotui.lcm.internal.client.Counters;
import org.robotui.lcm.internal.client.Inlet;

/** Datagrams that nobody means: what they cost is bounded, and whole messages still come through. */
class HostileDatagramsTest {

  private static final int ROUNDS = 20_000;
  private static final int MOST_MESSAGE = 1 << 20;

  private final List<LcmMessage> heard = new ArrayList<>();
  private final Counters counters = new Counters();

  private final class Ear implements Inlet {
    @Override
    public boolean wants(String channel) {
      return !channel.startsWith("X");
    }

    @Override
    public void deliver(LcmMessage message) {
      heard.add(message);
    }

    @Override
    public Counters counters() {
      return counters;
    }
  }

  private static byte[] shortOne(int sequence) {
    return ByteBuffer.allocate(8 + 5 + 20).putInt(Wire.SHORT).putInt(sequence).put("POSE\0".getBytes()).array();
  }

  private static byte[] fragment(int sequence, int number, int count) {
    byte[] name = number == 0 ? "SCAN\0".getBytes() : new byte[0];
    return ByteBuffer.allocate(20 + name.length + 300).putInt(Wire.FRAGMENT).putInt(sequence).putInt(300 * count)
        .putInt(300 * number)
        .putShort((short) number).putShort((short) count).put(name).array();
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3})
  void whateverComesIsDeliveredKeptWithinBoundsOrCounted(long seed) {
    Mutator mutator = new Mutator(seed);
    Inbox inbox = new Inbox(new Ear(),
        LcmOptions.standard(Thread.ofPlatform().factory()).withBounds(MOST_MESSAGE, 4 << 20, Duration.ofMillis(5)));
    for (int i = 0; i < ROUNDS; i++) {
      int sequence = mutator.random().nextInt(50);
      byte[] good = i % 3 == 0 ? shortOne(sequence) : fragment(sequence, mutator.random().nextInt(4), 4);
      byte[] datagram = mutator.random().nextInt(3) == 0 ? good : mutator.mutate(good);
      inbox.accept(new InetSocketAddress("10.0.0." + mutator.random().nextInt(3), 7000), ByteBuffer.wrap(datagram),
          i * 10_000L);
    }
    assertTrue(heard.size() > ROUNDS / 10, "heard " + heard.size());
    assertTrue(heard.stream().allMatch(m -> m.data().remaining() <= MOST_MESSAGE));
    int before = heard.size();
    InetSocketAddress honest = new InetSocketAddress("10.0.0.9", 7000);
    for (int number = 0; number < 4; number++) {
      inbox.accept(honest, ByteBuffer.wrap(fragment(77, number, 4)), ROUNDS * 10_000L);
    }
    assertTrue(heard.size() == before + 1 && heard.getLast().data().remaining() == 1200,
        "a whole message comes through");
  }
}
