package org.robotui.ui;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Set;
import java.util.stream.Collectors;
import org.eclipse.swt.graphics.Rectangle;
import org.junit.jupiter.api.Test;
import org.robotui.api.port.InputState;

class StateViewTest {
  private static final List<InputState> ALL = List.of(
      new InputState.Unconnected("nothing fits"),
      new InputState.Waiting("for the first scan"),
      new InputState.Live(10, 0.1),
      new InputState.Stale(2.1, "the link is lost"),
      new InputState.Failed("refused"));

  @Test
  void everyStateHasADotAndAWordOfItsOwn() {
    assertEquals(ALL.size(), ALL.stream().map(StateView::health).collect(Collectors.toSet()).size());
    Set<String> words = ALL.stream().map(StateView::word).collect(Collectors.toSet());
    assertEquals(ALL.size(), words.size());
    assertTrue(words.contains("stale 2.1\u00a0s"), words.toString());
  }

  @Test
  void whatNothingNewerCanComeOfSaysSinceWhenAndWhy() {
    InputState.Stale lost = InputState.Stale.lost(20, "base.map: nobody publishes /map any more", 12);
    assertEquals("lost for 12\u00a0s", StateView.word(lost));
    assertEquals("lost for 12\u00a0s  \u00b7  base.map: nobody publishes /map any more", StateView.sentence(lost));
    assertEquals("stale 2.1\u00a0s", StateView.sentence((InputState.Stale) ALL.get(3)));
    assertTrue(StateView.showsContent(lost));
  }

  @Test
  void theBannerOfOldDataCoversNoRowsWhereThereIsRoomBelowThem() {
    Rectangle area = new Rectangle(0, 0, 200, 300);

    assertEquals(new Rectangle(0, 56, 200, 244), StateView.belowRows(area, 56));
    int low = StateView.belowRows(area, 300).y;
    assertTrue(low > 200 && low < 300, "at the lower edge of a list that is full, not at " + low);
    assertEquals(0, StateView.belowRows(new Rectangle(0, 0, 200, 10), 40).y);
  }

  @Test
  void onlyLiveAndStaleDataIsShownAndStaleFades() {
    assertTrue(StateView.showsContent(ALL.get(2)) && StateView.showsContent(ALL.get(3)));
    assertFalse(StateView.showsContent(ALL.get(0)) || StateView.showsContent(ALL.get(4)));
    assertTrue(StateView.contentAlpha(ALL.get(3)) < StateView.contentAlpha(ALL.get(2)));
  }
}
