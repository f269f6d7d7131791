package org.robotui.ui.control;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Display;
import org.eclipse.swt.widgets.Shell;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledIf;
import org.robotui.testkit.Displays;
import org.robotui.testkit.TestDisplay;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;

@EnabledIf(value = Displays.AVAILABLE, disabledReason = Displays.REASON)
class DetailSplitSwtTest {
  private static final int HEIGHT = 400;
  private static final int NARROW = 300;
  private static final int BESIDE_FROM = 500;
  private static final int WIDE = 800;

  private final Display display = TestDisplay.get();
  private final Shell shell = new Shell(display, SWT.NO_TRIM);
  private final Theme theme = Themes.dark(display);
  private final Composite root = Boxes.panel(shell, theme, 1);
  private final DetailSplit split = new DetailSplit(root, theme, 60).besideFrom(BESIDE_FROM, 75).thin();
  private final Composite list = new Composite(split.parts(), SWT.NONE);
  private final Composite details = new Composite(split.parts(), SWT.NONE);

  @AfterEach
  void close() {
    shell.dispose();
    theme.dispose();
  }

  private void resize(int width) {
    root.setSize(width, HEIGHT);
    root.layout();
  }

  @Test
  void withoutDetailsTheListHasAllTheRoom() {
    split.detail(false);
    resize(NARROW);
    assertFalse(split.isDetailed());
    assertEquals(new Rectangle(0, 0, NARROW, HEIGHT), list.getBounds());
  }

  @Test
  void whereItIsNarrowTheDetailsStandBelow() {
    split.detail(true);
    resize(NARROW);
    assertEquals(NARROW, list.getSize().x);
    assertEquals(0.6, list.getSize().y / (double) HEIGHT, 0.01);
    assertTrue(details.getLocation().y > list.getSize().y);
  }

  @Test
  void whereItIsWideTheyStandBeside() {
    split.detail(true);
    resize(WIDE);
    assertEquals(HEIGHT, list.getSize().y);
    assertEquals(0.75, list.getSize().x / (double) WIDE, 0.01);
    assertTrue(details.getLocation().x > list.getSize().x);
  }

  @Test
  void whatTheUserDividedIsFoundAgain() {
    split.detail(true);
    resize(WIDE);
    ((SashForm) split.parts()).setWeights(50, 50);
    resize(NARROW);
    assertEquals(0.6, list.getSize().y / (double) HEIGHT, 0.01);
    resize(WIDE);
    assertEquals(0.5, list.getSize().x / (double) WIDE, 0.01);
  }

  @Test
  void itSaysWhetherSomethingHasChanged() {
    resize(NARROW);
    assertTrue(split.isDetailed());
    assertFalse(split.detail(true));
    assertTrue(split.detail(false));
    assertFalse(split.detail(false));
    assertTrue(split.detail(true));
  }
}
