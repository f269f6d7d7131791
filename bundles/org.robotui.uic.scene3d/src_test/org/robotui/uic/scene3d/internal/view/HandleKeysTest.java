package org.robotui.uic.scene3d.internal.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.eclipse.swt.SWT;
import org.junit.jupiter.api.Test;
import org.robotui.geometry.Vector3;
import org.robotui.gl.shape.Handle;
import org.robotui.gl.shape.Ray;

class HandleKeysTest implements Handle {
  private final HandleKeys keys = new HandleKeys(Runnable::run);
  private final List<Integer> chosen = new ArrayList<>();
  private List<Choice> menu =
      List.of(new Choice(3, "Open", false, List.of()), new Choice(5, "Move (Enter)", false, List.of()));

  @Override
  public void press(Ray ray, Vector3 place) {}

  @Override
  public void drag(Ray ray) {}

  @Override
  public void release(boolean clicked) {}

  @Override
  public List<Choice> menu() {
    return menu;
  }

  @Override
  public void choose(int id) {
    chosen.add(id);
  }

  @Test
  void aKeyChoosesTheEntryThatNamesItOfTheHandleThatWasGrippedLast() {
    assertFalse(keys.key(SWT.CR));
    keys.gripped(this);

    assertTrue(keys.key(SWT.CR));
    assertFalse(keys.key(SWT.ESC));
    assertFalse(keys.key('x'));
    menu = List.of();
    assertFalse(keys.key(SWT.KEYPAD_CR));

    assertEquals(List.of(5), chosen);
  }
}
