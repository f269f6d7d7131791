package org.robotui.guard.internal.process;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.robotui.guard.internal.wire.Wire;

/** Bytes that should be orders. */
class OrdersTest {
  private final List<String> taken = new ArrayList<>();

  private void follow(byte[] bytes) {
    new Orders(new DataInputStream(new ByteArrayInputStream(bytes))).follow(new Orders.Taker() {
      @Override
      public void beat() {
        taken.add("beat");
      }

      @Override
      public void keep(int id, InetSocketAddress to, byte[] words) {
        taken.add(id + " " + to + " " + words.length);
      }

      @Override
      public void withdraw(int id) {
        taken.add("withdraw " + id);
      }

      @Override
      public void end(boolean goodbye) {
        taken.add(goodbye ? "goodbye" : "gone");
      }
    });
  }

  private interface Writing {
    void to(DataOutputStream out) throws IOException;
  }

  private static byte[] bytes(Writing writing) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    writing.to(new DataOutputStream(bytes));
    return bytes.toByteArray();
  }

  private static void keep(DataOutputStream out, int addressBytes, int words) throws IOException {
    out.writeByte(Wire.KEEP);
    out.writeInt(5);
    out.writeByte(addressBytes);
    out.write(new byte[]{127, 0, 0, 1});
    out.writeShort(65535);
    out.writeInt(words);
  }

  @Test
  void orders_are_followed_to_the_goodbye() throws IOException {
    follow(bytes(out -> {
      out.writeByte(Wire.BEAT);
      keep(out, 4, 2);
      out.writeShort(0);
      out.writeByte(Wire.WITHDRAW);
      out.writeInt(5);
      out.writeByte(Wire.GOODBYE);
      out.writeByte(Wire.BEAT);
    }));
    assertEquals(List.of("beat", "5 /127.0.0.1:65535 2", "withdraw 5", "goodbye"), taken);
  }

  @Test
  void nonsense_ends_it_before_anything_is_allocated() throws IOException {
    follow(new byte[]{99});
    follow(bytes(out -> keep(out, 5, 0)));
    follow(bytes(out -> keep(out, 4, Wire.MOST_WORDS + 1)));
    follow(bytes(out -> keep(out, 4, -1)));
    follow(bytes(out -> keep(out, 4, 100)));
    follow(new byte[0]);
    assertEquals(List.of("gone", "gone", "gone", "gone", "gone", "gone"), taken);
  }

  @Test
  void any_bytes_end_in_one_way_or_the_other() {
    Random random = new Random(3);
    for (int i = 0; i < 20_000; i++) {
      byte[] bytes = new byte[random.nextInt(60)];
      random.nextBytes(bytes);
      if (bytes.length > 0) {
        bytes[0] = (byte) "BKWG".charAt(random.nextInt(4));
      }
      taken.clear();
      follow(bytes);
      assertEquals(1, taken.stream().filter(line -> line.equals("gone") || line.equals("goodbye")).count());
    }
  }
}
