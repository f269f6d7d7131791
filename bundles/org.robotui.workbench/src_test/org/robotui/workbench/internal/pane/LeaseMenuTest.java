package org.robotui.workbench.internal.pane;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.MenuItem;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.api.command.Principal;
import org.robotui.testkit.Displays;
import org.robotui.testkit.FakeAuthority;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.control.PopupMenu;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class LeaseMenuTest {
  private static final Principal YOU = new Principal("w", "You", Principal.Kind.WINDOW);
  private static final Principal BOB = new Principal("v", "Bob", Principal.Kind.WINDOW);

  private final List<FakeAuthority> robots =
      List.of(new FakeAuthority("r1"), new FakeAuthority("r2"), new FakeAuthority("r3"));
  private final List<String> changed = new ArrayList<>();
  private Shell shell;

  @BeforeEach
  void open() {
    shell = new Shell(TestDisplay.get());
  }

  @AfterEach
  void close() {
    shell.dispose();
  }

  private List<MenuItem> items() {
    PopupMenu menu = new LeaseMenu(shell, YOU, robot -> changed.add(robot.robot())).of(List.copyOf(robots));
    return Arrays.asList(menu.widget().getItems());
  }

  private List<String> words() {
    return items().stream().map(item -> (item.getSelection() ? "+" : "") + item.getText()).toList();
  }

  @Test
  void eachRobotIsTakenOrReleasedByItsEntry() {
    robots.get(0).take(YOU, false);
    robots.get(2).take(BOB, false);
    assertEquals(List.of("+Control r1", "Control r2", "Control r3  (Bob controls it)"), words());
    items().get(1).notifyListeners(SWT.Selection, new Event());
    assertEquals(List.of("r2"), changed);
  }

  @Test
  void whoControlsSeveralReleasesThemAtOnce() {
    robots.get(0).take(YOU, false);
    robots.get(1).take(YOU, false);
    assertEquals("Release all 2 that you control", items().getFirst().getText());
    items().getFirst().notifyListeners(SWT.Selection, new Event());
    assertEquals(List.of("r1", "r2"), changed);
  }
}
