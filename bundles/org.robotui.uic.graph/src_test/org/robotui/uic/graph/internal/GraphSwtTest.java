package org.robotui.uic.graph.internal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.FillLayout;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.graph.internal.model.Robots;
import org.robotui.uic.graph.internal.model.Vertex;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class GraphSwtTest {
  private final Theme theme = Themes.dark(TestDisplay.get());
  private final Shell shell = new Shell(TestDisplay.get(), SWT.NO_TRIM);
  private final FakeUicContext context = new FakeUicContext("graph", GraphOptions.schema());
  private GraphUic uic;
  private String note = "";

  @BeforeEach
  void open() {
    shell.setLayout(new FillLayout());
    shell.setSize(900, 500);
    context.robots(List.of(Robots.many(200, 2000).robot("base")));
    uic = new GraphUic(context);
    uic.createControl(shell, UiContext.of(theme, text -> note = text));
    shell.open();
    shell.layout(true, true);
  }

  @AfterEach
  void close() {
    uic.close();
    shell.dispose();
    theme.dispose();
  }

  private void ticks() {
    for (int i = 0; i < 3; i++) {
      uic.refresh();
      uic.tick(System.nanoTime());
    }
    uic.refresh();
    shell.update();
  }

  @Test
  void aLargeRobotIsShownAndItsNamespacesOpen() {
    ticks();
    assertEquals("200 nodes, 2000 topics", note);
    Vertex part = new Vertex(Vertex.Kind.GROUP, "base", "/part3");
    uic.ask(uic.asked().open(part, true).select(Optional.of(part)));
    ticks();
    assertTrue(uic.asked().opened().contains(part));
    assertTrue(uic.asked().selected().isPresent());
  }

  @Test
  void whatIsLeftOutIsKept() {
    uic.ask(uic.asked().show(false, false, true, true, false));
    assertEquals("nodes", context.settings().current().text(GraphOptions.SHOW));
    assertFalse(context.settings().current().flag(GraphOptions.DEBUG));
    try (GraphUic again = new GraphUic(context)) {
      assertEquals(uic.asked(), again.asked());
    }
  }
}
