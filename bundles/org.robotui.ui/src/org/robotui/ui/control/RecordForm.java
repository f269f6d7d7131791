package org.robotui.ui.control;

import java.time.Clock;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.ScrolledComposite;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.eclipse.swt.widgets.Listener;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordShape;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A form for the records of a type. Fields are checked while they are typed, and what is wrong is said at the field and
 * summed up below. A blank field is zero. Arrays of numbers are typed in one line, others element by element. Tab goes
 * from field to field, Ctrl+Enter submits. Display thread only.
 */
public final class RecordForm {
  private final Composite root;
  private final ScrolledComposite scrolled;
  private final Composite content;
  private final FormBody body;
  private final FormSummary summary;
  private final Clock clock;
  private Optional<FormModel> model = Optional.empty();
  private Runnable changed = () -> {};
  private Runnable submitted = () -> {};

  /**
   * A form without fields.
   *
   * @param parent the parent
   * @param theme colours and fonts
   */
  public RecordForm(Composite parent, Theme theme) {
    this(parent, theme, Clock.systemUTC());
  }

  RecordForm(Composite parent, Theme theme, Clock clock) {
    this.clock = clock;
    root = new Composite(parent, SWT.NONE);
    root.setBackground(theme.color(Role.PANEL));
    root.setLayout(layout());
    scrolled = new ScrolledComposite(root, SWT.V_SCROLL);
    scrolled.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    scrolled.setBackground(theme.color(Role.PANEL));
    scrolled.setExpandHorizontal(true);
    scrolled.setExpandVertical(true);
    scrolled.setShowFocusedControl(true);
    content = new Composite(scrolled, SWT.NONE);
    content.setBackground(theme.color(Role.PANEL));
    scrolled.setContent(content);
    summary = new FormSummary(root, theme, this::showProblem);
    body = new FormBody(content, theme, this::edited, this::fit);
    scrolled.addListener(SWT.Resize, e -> fit());
    submitOnKeys();
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return root;
  }

  /**
   * Makes the form one for records of a type. What was typed stays where the shape is the same.
   *
   * @param shape the form of the records
   */
  public void shape(RecordShape shape) {
    if (model.filter(m -> m.shape().equals(shape)).isEmpty()) {
      model = Optional.of(new FormModel(shape, clock));
      body.show(model.get());
      tell();
    }
  }

  /**
   * Takes over what a record holds, where it has fields of the form; the others are blank.
   *
   * @param record for example the newest of a topic
   */
  public void fill(DynamicRecord record) {
    model.ifPresent(m -> m.fill(record));
    renew();
  }

  /** Makes all fields blank. */
  public void reset() {
    model.ifPresent(m -> m.root().reset());
    renew();
  }

  /**
   * What was typed.
   *
   * @return the fields by name: Boolean, Long (BigInteger beyond), Double, String, nanoseconds as Long for times and
   * durations, List and Map; none while anything is wrong, or without a shape
   */
  public Optional<Map<String, Object>> values() {
    return model.flatMap(FormModel::values);
  }

  /**
   * What is wrong.
   *
   * @return in the order of the fields
   */
  public List<FormProblem> problems() {
    return model.map(FormModel::problems).orElse(List.of());
  }

  /** Puts the cursor into the first field that is wrong. */
  public void showProblem() {
    problems().stream().findFirst().ifPresent(problem -> body.focus(problem.path()));
  }

  /**
   * Tells when anything was typed, added or removed.
   *
   * @param action runs after it
   * @return this
   */
  public RecordForm onChange(Runnable action) {
    changed = action;
    return this;
  }

  /**
   * What Ctrl+Enter does.
   *
   * @param action for example sends {@link #values}
   * @return this
   */
  public RecordForm onSubmit(Runnable action) {
    submitted = action;
    return this;
  }

  FormBody body() {
    return body;
  }

  private void renew() {
    body.build();
    edited();
  }

  private void edited() {
    tell();
    changed.run();
  }

  private void tell() {
    summary.show(problems());
    fit();
  }

  private void fit() {
    int width = scrolled.getClientArea().width;
    scrolled.setMinSize(content.computeSize(Math.max(1, width), SWT.DEFAULT));
    content.layout(true, true);
  }

  /** The fields come and go, so the keys are heard at the display while the form is there. */
  private void submitOnKeys() {
    Listener keys = this::key;
    root.getDisplay().addFilter(SWT.KeyDown, keys);
    root.addListener(SWT.Dispose, e -> e.display.removeFilter(SWT.KeyDown, keys));
  }

  private void key(Event event) {
    boolean enter = event.keyCode == SWT.CR || event.keyCode == SWT.KEYPAD_CR;
    if (enter && (event.stateMask & SWT.MOD1) != 0 && event.widget instanceof Control control && within(control)) {
      event.doit = false;
      submitted.run();
    }
  }

  private boolean within(Control control) {
    for (Composite at = control.getParent(); at != null; at = at.getParent()) {
      if (at == content) {
        return true;
      }
    }
    return false;
  }

  private static GridLayout layout() {
    GridLayout layout = new GridLayout(1, false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    layout.verticalSpacing = 0;
    return layout;
  }
}
