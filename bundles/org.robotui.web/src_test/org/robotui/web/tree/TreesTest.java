package org.robotui.web.tree;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

class TreesTest {

  private static final String JSON =
      "{\"op\":\"x\",\"n\":-3,\"r\":1.5,\"a\":[1,2],\"b\":[1,null,2.5],\"c\":[1,\"t\"],\"d\":{\"e\":null,\"f\":NaN}}";
  /** {"a": h'0102', "b": typed array of two little-endian singles, "c": [1, -2, 1.5], "d": null}. */
  private static final String CBOR = "a4" + "6161" + "420102" + "6162" + "d855480000803f00000040" + "6163"
      + "830121f93e00" + "6164" + "f6";

  @Test
  void jsonBecomesPlainValues() throws TreeException {
    Map<String, Object> tree = Trees.object(JsonText.read(JSON));
    assertEquals(-3L, tree.get("n"));
    assertEquals(1.5, tree.get("r"));
    assertArrayEquals(new long[]{1, 2}, (long[]) tree.get("a"));
    assertArrayEquals(new double[]{1, Double.NaN, 2.5}, (double[]) tree.get("b"));
    assertEquals(JsonNull.NULL, Trees.object(tree.get("d")).get("e"));
  }

  @Test
  void whatWasReadIsWrittenAgain() throws TreeException {
    String written = JsonText.write(JsonText.read(JSON));
    assertEquals(written, JsonText.write(JsonText.read(written)));
  }

  @Test
  void onlyTheBeginningIsNeededToSortAFloodOut() {
    Map.Entry<String, String> found =
        JsonText.peek("{\"op\":\"publish\",\"topic\":\"/a\",\"msg\":{ broken", "op", "topic")
            .orElseThrow();
    assertEquals(Map.entry("publish", "/a"), found);
  }

  @Test
  void cborBecomesTheSame() throws TreeException {
    Map<String, Object> tree = Trees.object(Cbor.read(ByteBuffer.wrap(HexFormat.of().parseHex(CBOR))));
    assertArrayEquals(new byte[]{1, 2}, (byte[]) tree.get("a"));
    assertArrayEquals(new double[]{1, 2}, (double[]) tree.get("b"));
    assertArrayEquals(new double[]{1, -2, 1.5}, (double[]) tree.get("c"));
  }

  @Test
  void nestingAndLengthsAreBounded() {
    assertThrows(TreeException.class, () -> JsonText.read("[".repeat(100) + "]".repeat(100)));
    assertThrows(TreeException.class, () -> JsonText.read("[" + "[],".repeat(1_000_001) + "[]]"));
    byte[] deep = new byte[10_000];
    Arrays.fill(deep, (byte) 0x81);
    assertThrows(TreeException.class, () -> Cbor.read(ByteBuffer.wrap(deep)));
    byte[] lying = HexFormat.of().parseHex("5b7fffffffffffffff00");
    assertThrows(TreeException.class, () -> Cbor.read(ByteBuffer.wrap(lying)));
  }

  @Test
  void damagedInputIsReadOrRefusedButNothingElse() {
    Random random = new Random(11);
    int refused = 0;
    for (int i = 0; i < 20_000; i++) {
      refused += refuses(damaged(HexFormat.of().parseHex(CBOR), random), true) ? 1 : 0;
      refused += refuses(damaged(JSON.getBytes(StandardCharsets.UTF_8), random), false) ? 1 : 0;
    }
    assertTrue(refused > 1000, "only " + refused + " were refused");
  }

  private static boolean refuses(byte[] bytes, boolean cbor) {
    try {
      Object tree = cbor ? Cbor.read(ByteBuffer.wrap(bytes)) : JsonText.read(bytes);
      return tree == null;
    } catch (TreeException e) {
      return true;
    }
  }

  private static byte[] damaged(byte[] good, Random random) {
    byte[] bad = Arrays.copyOf(good, random.nextInt(good.length) + 1);
    for (int i = random.nextInt(4); i > 0; i--) {
      bad[random.nextInt(bad.length)] = (byte) random.nextInt(256);
    }
    return bad;
  }
}
