package org.robotui.rosbridge.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.robotui.net.call.Outcome;
import org.robotui.rosbridge.BridgeMessage;
import org.robotui.web.Arrivals;
import org.robotui.web.tree.TreeException;

class BridgeEarTest {
  private static final String PUBLISH = "{\"op\":\"publish\",\"topic\":\"/a\",\"msg\":{\"x\":[1,2],\"y\":\"z\"}}";
  /** {op: publish, topic: /a, msg: {secs: 1, nsecs: 2, bytes: h'010203'}}. */
  private static final byte[] RAW =
      HexFormat.of().parseHex("a3626f70677075626c69736865746f706963622f61636d7367a36473656373"
          + "01656e736563730265627974657343010203");

  private final List<String> complaints = new ArrayList<>();
  private final BlockingQueue<Parcel> parcels = new LinkedBlockingQueue<>();
  private final Arrivals arrivals = new Arrivals(Thread.ofPlatform().daemon().factory());
  private final BridgeEar ear = new BridgeEar("ws://robot", complaints::add);

  @AfterEach
  void end() {
    arrivals.close();
  }

  private BridgeMessage next() throws InterruptedException, TreeException {
    return parcels.poll(10, TimeUnit.SECONDS).open();
  }

  @Test
  void messagesGoToThoseWhoReceiveTheirTopic() throws InterruptedException, TreeException {
    ear.topics().put("/a", List.of(arrivals.source(10, parcels::add)));
    ear.onText(PUBLISH.replace("/a", "/b"));
    ear.onText(PUBLISH);
    assertEquals("z", assertInstanceOf(BridgeMessage.Tree.class, next()).fields().get("y"));
    ear.onBinary(ByteBuffer.wrap(RAW));
    assertEquals(ByteBuffer.wrap(new byte[]{1, 2, 3}), assertInstanceOf(BridgeMessage.Raw.class, next()).bytes());
    assertTrue(complaints.isEmpty(), complaints.toString());
  }

  @Test
  void aServiceThatFailsSaysWhy() throws InterruptedException {
    Outcome<Map<String, Object>> outcome = ear.calls().ask("/s", Duration.ofSeconds(10), id -> {
      ear.onText("{\"op\":\"service_response\",\"id\":\"" + id + "\",\"result\":false,\"values\":\"no such thing\"}");
      return true;
    });
    assertEquals("no such thing", assertInstanceOf(Outcome.Refused.class, outcome).reason());
  }

  @Test
  void damagedMessagesAreRefusedAndNothingElse() {
    Random random = new Random(7);
    ear.topics().put("/a", List.of(arrivals.source(1, parcel -> {})));
    for (int i = 0; i < 20_000; i++) {
      ear.onText(new String(damaged(PUBLISH.getBytes(StandardCharsets.UTF_8), random), StandardCharsets.UTF_8));
      ear.onBinary(ByteBuffer.wrap(damaged(RAW, random)));
    }
    assertTrue(complaints.size() > 5000, "only " + complaints.size());
  }

  private static byte[] damaged(byte[] good, Random random) {
    byte[] bad = Arrays.copyOf(good, random.nextInt(good.length) + 1);
    bad[random.nextInt(bad.length)] = (byte) random.nextInt(256);
    return bad;
  }

  @Test
  void definitionsInPartsBecomeTheTextOfRos() throws TreeException {
    Map<String, Object> outer = Map.of("type", "a/B", "fieldnames", List.of("c", "d", "e"), "fieldtypes",
        List.of("a/C", "float64", "string"), "fieldarraylen", new long[]{-1, 9, 0});
    Map<String, Object> inner = Map.of("type", "a/C", "fieldnames", List.of("x"), "fieldtypes", List.of("uint8"),
        "fieldarraylen", new long[]{-1});
    assertEquals("a/C c\nfloat64[9] d\nstring[] e\n" + "=".repeat(80) + "\nMSG: a/C\nuint8 x\n",
        TypeText.of(List.of(outer, inner)));
    Map<String, Object> odd = Map.of("type", "a/B", "fieldnames", List.of("c"), "fieldtypes", List.of());
    assertThrows(TreeException.class, () -> TypeText.of(List.of(odd)));
  }
}
