package org.robotui.net.log;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class LogTest {

  @Test
  void everFewerOfLikeEventsAreLogged() {
    LogThrottle throttle = new LogThrottle();
    List<Integer> logged = IntStream.rangeClosed(1, 20).filter(i -> throttle.admit()).boxed().toList();
    assertEquals(List.of(1, 2, 4, 8, 16), logged);
    assertEquals(20, throttle.count());
  }

  @Test
  void whatPeersSayIsShortAndOfOneLine() {
    assertEquals("a b c", PeerText.brief("a\r\nb\u0000c"));
    assertEquals("x".repeat(500) + "...", PeerText.brief("x".repeat(1_000_000)));
    assertEquals("x".repeat(150) + "...", PeerText.name("x".repeat(151)));
  }
}
