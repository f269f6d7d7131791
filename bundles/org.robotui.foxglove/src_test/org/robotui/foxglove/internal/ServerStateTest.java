package org.robotui.foxglove.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.net.call.Outcome;

class ServerStateTest {

  private static final String ADVERTISE = "{\"op\":\"advertise\",\"channels\":[{\"id\":1,\"topic\":\"/a\","
      + "\"encoding\":\"json\",\"schemaName\":\"A\",\"schema\":\"{}\"}]}";

  private final List<String> complaints = new ArrayList<>();
  private final ServerState ear = new ServerState("ws://robot", complaints::add);

  @Test
  void remembersWhatTheServerHas() {
    ear.onText("{\"op\":\"serverInfo\",\"name\":\"r\",\"capabilities\":[\"time\"],\"supportedEncodings\":[\"json\"]}");
    ear.onText(ADVERTISE);
    assertTrue(ear.info().orElseThrow().can("time"));
    assertEquals("/a", ear.channels().getFirst().topic());
    ear.onText("{\"op\":\"unadvertise\",\"channelIds\":[1]}");
    assertTrue(ear.channels().isEmpty());
    assertTrue(complaints.isEmpty(), complaints.toString());
  }

  @Test
  void complainsOfWhatNobodyCanReadAndGoesOn() {
    ear.onText("{\"op\":");
    ear.onText("{\"op\":\"advertise\",\"channels\":[{}]}");
    ear.onBinary(ByteBuffer.wrap(new byte[]{1, 2, 3}));
    assertEquals(3, complaints.size(), complaints.toString());
    ear.onText(ADVERTISE);
    assertEquals(1, ear.channels().size());
  }

  @Test
  void aCallEndsWithTheLink() throws InterruptedException {
    Outcome<ByteBuffer> outcome = ear.calls().ask("s", Duration.ofSeconds(10), id -> {
      ear.ended("gone");
      return true;
    });
    assertInstanceOf(Outcome.Failed.class, outcome);
    assertEquals("gone", outcome.reason());
  }

  @Test
  void damagedMessagesAreRefusedAndNothingElse() {
    Random random = new Random(5);
    byte[] reply = {3, 1, 0, 0, 0, 2, 0, 0, 0, 4, 0, 0, 0, 'j', 's', 'o', 'n', 7};
    for (int i = 0; i < 20_000; i++) {
      ear.onBinary(ByteBuffer.wrap(damaged(reply, random)));
      ear.onText(new String(damaged(ADVERTISE.getBytes(StandardCharsets.UTF_8), random), StandardCharsets.UTF_8));
    }
    assertTrue(complaints.size() > 1000, "only " + complaints.size());
  }

  private static byte[] damaged(byte[] good, Random random) {
    byte[] bad = Arrays.copyOf(good, random.nextInt(good.length) + 1);
    bad[random.nextInt(bad.length)] = (byte) random.nextInt(256);
    return bad;
  }
}
