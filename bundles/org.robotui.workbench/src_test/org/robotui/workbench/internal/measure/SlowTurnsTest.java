package org.robotui.workbench.internal.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class SlowTurnsTest {
  private final SlowTurns turns = new SlowTurns();

  @Test
  void aTurnIsToldWithTheViewAndTheLineThatWereFoundMostOften() {
    turns.look(frame("org.robotui.core.internal.life.Snapshots", 29),
        frame("org.robotui.workbench.internal.rcp.StatusControl", 25));
    for (int i = 0; i < 2; i++) {
      turns.look(frame("org.eclipse.swt.graphics.GC", 1), frame("org.robotui.ui.scene.Painter", 7),
          frame("org.robotui.uic.map.internal.view.MapCanvas", 90),
          frame("org.robotui.workbench.internal.pane.ViewHolder", 3));
    }
    turns.over(42, 7);
    SlowTurns.Turn worst = turns.worst().getFirst();
    assertEquals("org.robotui.uic.map", worst.view());
    assertEquals("org.robotui.ui.scene.Painter.run(Painter.java:7)", worst.at());
    assertEquals(42, worst.millis());
    assertEquals(7, worst.afterSeconds());
  }

  @Test
  void whatWasFoundInOneTurnIsNotToldOfAnother() {
    turns.look(frame("org.robotui.uic.map.internal.view.MapCanvas", 90));
    turns.forget();
    turns.over(9, 1);
    assertEquals(new SlowTurns.Turn(9, 1, "", ""), turns.worst().getFirst());
  }

  @Test
  void onlyTheSlowestAreKeptWorstFirst() {
    IntStream.rangeClosed(1, 100).forEach(i -> turns.over(i * 37 % 101, i));
    List<Double> kept = turns.worst().stream().map(SlowTurns.Turn::millis).toList();
    assertEquals(100, kept.getFirst());
    assertEquals(kept.stream().sorted((a, b) -> Double.compare(b, a)).toList(), kept);
    assertTrue(kept.size() < 20);
    assertTrue(kept.getLast() > 90);
  }

  private static StackTraceElement frame(String type, int line) {
    return new StackTraceElement(type, "run", type.substring(type.lastIndexOf('.') + 1) + ".java", line);
  }
}
