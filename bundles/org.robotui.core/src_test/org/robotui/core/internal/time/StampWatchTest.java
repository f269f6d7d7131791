package org.robotui.core.internal.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.core.internal.support.ManualClock;
import org.robotui.data.ClockKind;
import org.robotui.data.Stamp;

class StampWatchTest {
  private static final long START = 1_700_000_000_000L;

  private final ManualClock mono = new ManualClock();
  private final List<Double> jumps = new ArrayList<>();
  private final List<String> disagreements = new ArrayList<>();
  private final StampWatch watch = new StampWatch(mono, new StampWatch.Ear() {
    @Override
    public void jumpedBack(double seconds) {
      jumps.add(seconds);
    }

    @Override
    public void disagree(List<String> fallen, List<String> goingOn, double seconds) {
      disagreements.add(fallen + " " + goingOn);
    }
  });

  /** Ten times a second for a time; stamps are milliseconds after the start. */
  private void play(long fromMillis, long forMillis, String... speakers) {
    for (long t = 0; t < forMillis; t += 100) {
      for (String speaker : speakers) {
        say(speaker, fromMillis + t);
      }
      mono.advanceMillis(100);
    }
  }

  private void say(String speaker, long millis) {
    watch.heard(speaker, new Stamp((START + millis) * 1_000_000, ClockKind.ROBOT));
  }

  @Test
  void aRecordingThatBeginsAnewIsNoticedOnceAndSoon() {
    play(0, 20_000, "scan", "tf", "odom");
    play(0, 300, "scan", "tf", "odom");
    assertEquals(1, jumps.size());
    assertEquals(19.9, jumps.getFirst(), 0.3);
    play(300, 20_000, "scan", "tf", "odom");
    assertEquals(1, jumps.size());
    play(0, 1_000, "scan", "tf", "odom");
    assertEquals(2, jumps.size());
    assertTrue(disagreements.isEmpty());
  }

  @Test
  void whoSpeaksSeldomBelongsToTheSameJump() {
    say("map", 500);
    play(0, 20_000, "scan", "tf");
    say("map", 20_000);
    play(0, 5_000, "scan", "tf");
    assertEquals(1, jumps.size());
    say("map", 500);
    play(5_000, 3_000, "scan", "tf");
    assertEquals(1, jumps.size());
  }

  @Test
  void aSingleSpeakerIsBelievedAfterAWhile() {
    play(0, 20_000, "scan");
    play(0, 1_000, "scan");
    assertTrue(jumps.isEmpty());
    play(1_000, 1_000, "scan");
    assertEquals(1, jumps.size());
  }

  @Test
  void whereOthersGoOnItIsSaidAndNothingIsForgotten() {
    play(0, 5_000, "scan", "tf", "wall");
    for (int i = 0; i < 30; i++) {
      play(i * 100, 100, "scan", "tf");
      say("wall", 5_000 + i * 100);
    }
    assertTrue(jumps.isEmpty());
    assertEquals(List.of("[scan, tf] [wall]"), disagreements);
  }

  @Test
  void oneWrongStampIsNoJump() {
    play(0, 5_000, "scan", "tf");
    say("tf", 0);
    play(5_000, 5_000, "scan", "tf");
    assertTrue(jumps.isEmpty());
    assertTrue(disagreements.isEmpty());
  }

  @Test
  void twoClocksInTurnAreNoJump() {
    for (int i = 0; i < 100; i++) {
      play(i * 100, 100, "scan");
      say("scan", i * 100 + 10_000);
    }
    assertTrue(jumps.isEmpty());
  }

  @Test
  void simulatedTimeIsToldByItsClock() {
    for (long stamp : new long[]{20_000, 0, 100, 5_000}) {
      watch.heard("scan", new Stamp(stamp * 1_000_000, ClockKind.SIMULATED));
      mono.advanceMillis(2_000);
    }
    assertTrue(jumps.isEmpty());
  }
}
