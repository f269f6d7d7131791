package org.robotui.core.internal.time;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.robotui.api.frame.FrameLink;
import org.robotui.data.ClockKind;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.data.geometry.FrameTransform;
import org.robotui.data.geometry.TransformSet;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.TransformLookup;

class RuicFramesTest {
  private static final FrameId ODOM = new FrameId("one", "odom");
  private static final FrameId BASE = new FrameId("one", "base_link");
  private static final FrameId LASER = new FrameId("one", "laser");
  private static final FrameId OTHER_BASE = new FrameId("two", "base_link");

  private long now = 1_000_000_000L;
  private final RuicFrames frames = new RuicFrames(List.of(), () -> now);

  private static FrameTransform edge(FrameId parent, FrameId child, double x, long seconds, boolean fixed) {
    Stamp stamp = Stamp.of(seconds, 0, ClockKind.ROBOT);
    return new FrameTransform(parent, child, stamp, RigidTransform.planar(x, 0, 0), fixed);
  }

  private void add(FrameTransform... transforms) {
    frames.add(new TransformSet(List.of(transforms)), "test");
  }

  @Test
  void looksUpAlongTheChainAtATimeAndNow() {
    add(edge(ODOM, BASE, 1, 10, false), edge(ODOM, BASE, 3, 12, false), edge(BASE, LASER, 0.5, 0, true));
    Optional<Stamp> between = Optional.of(Stamp.of(11, 0, ClockKind.ROBOT));
    assertEquals(2.5, frames.lookup(ODOM, LASER, between).transform().orElseThrow().translation().x(), 1e-9);
    assertEquals(3.5, frames.lookup(ODOM, LASER, Optional.empty()).transform().orElseThrow().translation().x(), 1e-9);
    assertEquals(Optional.of(BASE), frames.parent(LASER));
    assertEquals(Optional.empty(), frames.parent(ODOM));
  }

  @Test
  void framesOfOneNameOfTwoRobotsAreTwo() {
    add(edge(ODOM, BASE, 1, 10, false), edge(new FrameId("two", "odom"), OTHER_BASE, 5, 10, false));
    assertInstanceOf(TransformLookup.Disconnected.class, frames.lookup(BASE, OTHER_BASE, Optional.empty()));
    assertEquals(List.of(BASE, ODOM, OTHER_BASE, new FrameId("two", "odom")), frames.all());
  }

  @Test
  void impossibleTransformsAreRefusedAndCounted() {
    add(edge(ODOM, ODOM, 1, 10, false));
    assertEquals(1, frames.refused());
    assertEquals(List.of(), frames.all());
  }

  @Test
  void jumpBackForgetsAllButFixedTransforms() {
    add(edge(ODOM, BASE, 1, 100, false), edge(BASE, LASER, 0.5, 0, true));
    frames.clear();
    assertTrue(frames.lookup(ODOM, BASE, Optional.empty()).transform().isEmpty());
    assertTrue(frames.lookup(BASE, LASER, Optional.empty()).transform().isPresent());
    add(edge(ODOM, BASE, 2, 1, false));
    assertEquals(2, frames.lookup(ODOM, BASE, Optional.empty()).transform().orElseThrow().translation().x(), 1e-9);
    frames.reset();
    assertEquals(List.of(), frames.all());
  }

  @Test
  void saysWhoSendsATransformHowOftenAndHowOldItIs() {
    for (int i = 0; i < 30; i++) {
      add(edge(ODOM, BASE, i, 10 + i, false));
      now += 100_000_000L;
    }
    add(edge(BASE, LASER, 0.5, 0, true));
    FrameLink moving = link(BASE);
    assertEquals(10, moving.rateHz(), 0.01);
    assertEquals("test", moving.authority());
    assertEquals(39, moving.newest().orElseThrow().seconds(), 1e-9);
    assertEquals(10, moving.heldSeconds(), 1e-9);
    assertEquals(100_000_000L, now - moving.receivedNanos());
    assertEquals(List.of(), moving.rivals());
    FrameLink fixed = link(LASER);
    assertTrue(fixed.fixed());
    assertEquals(Optional.empty(), fixed.newest());
    now += 5_000_000_000L;
    assertEquals(0, link(BASE).rateHz(), "it ceased");
  }

  @Test
  void twoWhoSayItAreRivalsAndASuccessorIsNone() {
    FrameId map = new FrameId("one", "map");
    say(ODOM, "first");
    say(ODOM, "second");
    assertEquals(List.of(), link(BASE).rivals(), "one came after the other");
    say(map, "first");
    say(ODOM, "second");
    assertEquals(List.of(new FrameLink.Rival("first", map)), link(BASE).rivals());
    now += 11_000_000_000L;
    say(ODOM, "second");
    assertEquals(List.of(), link(BASE).rivals(), "long ago");
  }

  @Test
  void refusalsAreListedOnceForEachReasonAndBounded() {
    for (int i = 0; i < 3; i++) {
      now++;
      add(edge(ODOM, ODOM, 1, 10, false));
    }
    assertEquals(1, frames.refusals().size());
    assertEquals(3, frames.refusals().getFirst().count());
    for (int i = 0; i < 100; i++) {
      now++;
      FrameId one = new FrameId("one", "f" + i);
      add(edge(one, one, 1, 10, false));
    }
    assertEquals(20, frames.refusals().size());
    assertTrue(frames.refusals().getFirst().reason().contains("f99"));
    frames.reset();
    assertEquals(List.of(), frames.refusals());
  }

  private void say(FrameId parent, String authority) {
    now += 10_000_000L;
    frames.add(new TransformSet(List.of(edge(parent, BASE, 1, 10 + now / 1_000_000_000L, false))), authority);
  }

  private FrameLink link(FrameId child) {
    return frames.links().stream().filter(l -> l.child().equals(child)).findFirst().orElseThrow();
  }
}
