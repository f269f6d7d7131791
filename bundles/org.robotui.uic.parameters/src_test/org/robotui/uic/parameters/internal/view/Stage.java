package org.robotui.uic.parameters.internal.view;

import java.util.Optional;
import java.util.function.Supplier;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Text;
import org.robotui.uic.parameters.internal.ParametersOptions;
import org.robotui.uic.parameters.internal.model.Key;
import org.robotui.uic.parameters.internal.model.ParametersModel;

/** A surface in the hands of a test. */
public final class Stage {
  private final ParametersSurface surface;
  private final ParametersModel model;
  private final Supplier<ParametersOptions> options;

  public Stage(ParametersSurface surface, ParametersModel model, Supplier<ParametersOptions> options) {
    this.surface = surface;
    this.model = model;
    this.options = options;
  }

  /** Lets the model and the display come to rest. */
  public void settle() {
    for (int i = 0; i < 6; i++) {
      model.tick(System.nanoTime(), options.get());
      surface.refresh();
      while (surface.control().getDisplay().readAndDispatch()) {
        continue;
      }
    }
  }

  /** Turns to running programs, or to parameters. */
  public void leaf(boolean programs) {
    surface.leaf(programs);
    settle();
  }

  public String words() {
    return surface.filterField().words();
  }

  public void filter(String words) {
    surface.filterField().words(words);
  }

  /** Types into the editor of a value; nothing is set. */
  public void edit(String name, String text) {
    surface.tree().table().list().select(new Key("base", name));
    surface.tree().edit();
    surface.tree().editor().field().ifPresent(field -> field.setText(text));
  }

  public Optional<Text> editor() {
    return surface.tree().editor().field();
  }

  public void enter() {
    enter(0);
  }

  public void controlEnter() {
    enter(SWT.MOD1);
  }

  private void enter(int modifiers) {
    Event event = new Event();
    event.stateMask = modifiers;
    event.keyCode = SWT.CR;
    editor().ifPresent(field -> field.notifyListeners(SWT.KeyDown, event));
  }

  /** Types into a field of the form and leaves it. */
  public void type(String name, String text) {
    row(name).flatMap(KnobRow::field).ifPresent(field -> {
      field.setText(text);
      field.notifyListeners(SWT.DefaultSelection, new Event());
    });
  }

  public void drag(String name, double share) {
    row(name).flatMap(KnobRow::bar).ifPresent(bar -> {
      Event event = new Event();
      event.button = 1;
      event.x = (int) (share * bar.getClientArea().width);
      bar.notifyListeners(SWT.MouseDown, event);
    });
  }

  public Optional<String> fieldText(String name) {
    return row(name).flatMap(KnobRow::field).map(Text::getText);
  }

  private Optional<KnobRow> row(String name) {
    return surface.tuner().form().rows().stream().filter(r -> r.knob().tunable().name().equals(name)).findFirst();
  }
}
