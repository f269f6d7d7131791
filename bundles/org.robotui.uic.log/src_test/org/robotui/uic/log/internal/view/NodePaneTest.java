package org.robotui.uic.log.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.robotui.uic.log.internal.model.LogFilter;
import org.robotui.uic.log.internal.model.OriginCount;
import org.robotui.ui.ViewAction;

class NodePaneTest {
  private final List<LogFilter> asked = new java.util.ArrayList<>();

  @Test
  void nodesThatAFilterNamesStayInTheListAlsoWhenTheySayNothing() {
    List<OriginCount> seen = List.of(new OriginCount("/b", 3));
    assertEquals(List.of(new OriginCount("/a", 0), new OriginCount("/b", 3)),
        NodePane.rows(seen, LogFilter.ALL.origin("/a", false)));
    assertEquals(seen, NodePane.rows(seen, LogFilter.ALL));
  }

  @Test
  void theMenuShowsOneNodeAloneHidesItOrShowsAll() {
    List<ViewAction> menu = NodePane.menu(List.of(new OriginCount("/a", 1)), LogFilter.ALL, new Asked(asked));
    assertEquals(List.of("Only /a", "Hide /a", "Show all nodes"), menu.stream().map(ViewAction::label).toList());
    menu.forEach(action -> action.run().run());
    assertTrue(asked.get(0).shows("/a") && !asked.get(0).shows("/b"));
    assertTrue(!asked.get(1).shows("/a") && asked.get(1).shows("/b"));
    assertEquals(LogFilter.ALL, asked.get(2));
  }
}
