package org.robotui.recording.internal.chunk;

import static org.junit.jupiter.api.Assertions.assertEquals;

import com.github.luben.zstd.Zstd;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

/** Chunks of files that lie about their channels, in a recording of several files. */
class RenumberedTest {
  private static final Map<Integer, Integer> NUMBERS = Map.of(7, 0, 9, 1);
  private static final int UNKNOWN = 8;

  private static LoadedChunk chunk(byte[] message) {
    EntryTable entries = new EntryTable();
    for (int channel : new int[]{7, UNKNOWN, 9}) {
      entries.add(channel, channel, channel, 0, 0, message.length);
    }
    return entries.over(message);
  }

  private static List<Integer> channels(LoadedChunk chunk) {
    return IntStream.range(0, chunk.size()).mapToObj(chunk::channel).toList();
  }

  @Test
  void messagesOfChannelsThatTheFileDoesNotDescribeAreLeftOut() {
    assertEquals(List.of(0, 1), channels(chunk(new byte[4]).renumbered(NUMBERS)));
  }

  @Test
  void soAreThoseThatAreCompressed() {
    LoadedChunk packed = chunk(Zstd.compress("plain".getBytes(StandardCharsets.UTF_8)));
    DamageList damages = new DamageList();
    LoadedChunk plain = new MessageUnpacking().unpacked(packed, NUMBERS, damages);
    assertEquals(List.of(0, 1), channels(plain));
    assertEquals("plain", StandardCharsets.UTF_8.decode(plain.data(1)).toString());
    assertEquals(List.of(), damages.all());
  }
}
