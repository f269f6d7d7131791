package org.robotui.uic.topics.internal.view;

import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Text;
import org.robotui.api.input.TypedText;
import org.robotui.api.input.Unreadable;
import org.robotui.data.command.MessageCommand;
import org.robotui.data.record.DynamicRecord;
import org.robotui.data.record.RecordShape;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.MessagePane;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.PlainLabel;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RecordForm;
import org.robotui.uic.topics.internal.model.Described;
import org.robotui.uic.topics.internal.model.Key;
import org.robotui.uic.topics.internal.model.Speaker;
import org.robotui.uic.topics.internal.model.Speech;
import org.robotui.uic.topics.internal.model.TopicsModel;
import org.robotui.uic.topics.internal.model.TopicsViewState;

/** A form of a message, to say it on its topic once or again and again. Display thread. */
final class PublishPane {
  private static final int RATE_WIDTH = 44;
  private static final String RATES = "from 0.1 to 50 Hz";

  private final TopicsModel model;
  private final Composite root;
  private final Composite body;
  private final RecordForm form;
  private final MessagePane obstacle;
  private final Composite bar;
  private final QuietButton once;
  private final QuietButton repeat;
  private final QuietButton prefill;
  private final Text rate;
  private final NoticeLine outcome;
  private final QuietButton takeOver;
  private final QuietButton leave;
  private Optional<Described> about = Optional.empty();
  private boolean awaited;
  private boolean repeating;

  PublishPane(Composite parent, Theme theme, TopicsModel model) {
    this.model = model;
    root = Boxes.panel(parent, theme, 1);
    obstacle = new MessagePane(root, theme);
    obstacle.control().setLayoutData(Boxes.fill());
    body = Boxes.panel(root, theme, 1);
    body.setLayoutData(Boxes.fill());
    form = new RecordForm(body, theme).onChange(this::changed).onSubmit(this::say);
    form.control().setLayoutData(Boxes.fill());
    Boxes.rule(body, theme);
    bar = Boxes.bar(body, theme, 5);
    once = new QuietButton(bar, theme, this::say).text("Publish once").fill(Role.ACCENT)
        .hint("Publishes the message once (Ctrl+Enter)");
    repeat = new QuietButton(bar, theme, this::repeat).text("Repeat")
        .hint("Publishes the message repeatedly until it is ended");
    repeat.setLayoutData(Boxes.middle());
    ((GridData) repeat.getLayoutData()).widthHint = repeat.computeSize(SWT.DEFAULT, SWT.DEFAULT).x;
    rate = rate(bar, theme);
    label(bar, theme, "Hz");
    prefill = new QuietButton(bar, theme, this::prefill).icon(Icon.SAVE)
        .hint("Fill the form in with the newest message of the topic");
    prefill.setLayoutData(new GridData(SWT.END, SWT.CENTER, true, false));
    Composite foot = Boxes.bar(body, theme, 3);
    outcome = new NoticeLine(foot, theme, Face.BODY);
    takeOver = new QuietButton(foot, theme, () -> model.speaker().takeOver()).text("Take over").fill(Role.ACCENT);
    takeOver.setLayoutData(Boxes.middle());
    leave = new QuietButton(foot, theme, () -> model.speaker().leave()).text("Cancel");
    leave.setLayoutData(Boxes.middle());
    Boxes.seen(takeOver, false);
    Boxes.seen(leave, false);
  }

  Control control() {
    return root;
  }

  RecordForm form() {
    return form;
  }

  void show(TopicsViewState look, Described described) {
    if (!about.map(Described::key).equals(Optional.of(described.key()))) {
      model.speaker().stop("another topic was chosen");
      awaited = false;
    }
    about = Optional.of(described);
    String why = model.silenced(described);
    obstacle.show(described.failure().isPresent() && described.description().isEmpty() ? Health.BAD : Health.NONE,
        "Not possible", why);
    if (Boxes.seen(obstacle.control(), !why.isEmpty()) | Boxes.seen(body, why.isEmpty())) {
      root.layout();
    }
    shape().ifPresent(form::shape);
    fillAwaited(look);
    speech(look.speech());
  }

  private void speech(Speech speech) {
    repeating = speech.hertz().isPresent();
    repeat.text(repeating ? "End" : "Repeat").checked(repeating);
    once.setEnabled(!repeating);
    rate.setEnabled(!repeating);
    boolean untold = speech.asking() || speech.outcome().isEmpty();
    outcome.show(speech.health(), untold ? lease(speech.lease()) : speech.outcome());
    if (Boxes.seen(takeOver, speech.asking()) | Boxes.seen(leave, speech.asking())) {
      takeOver.getParent().layout();
    }
  }

  private static String lease(Speech.Lease lease) {
    return switch (lease) {
      case Speech.Lease.Free f -> "Nobody has control; the first message takes it.";
      case Speech.Lease.Mine m -> "You have control.";
      case Speech.Lease.Other o -> o.name() + " has control.";
    };
  }

  /** Says the message of the form once. */
  void say() {
    message(m -> model.speaker().once(m));
  }

  /** Begins or ends the repetition; it lasts while the focus is here, so it takes it. */
  void repeat() {
    repeat.forceFocus();
    if (repeating) {
      model.speaker().stop("");
      return;
    }
    try {
      double hertz = hertz();
      message(m -> model.speaker().repeat(m, hertz, System.nanoTime()));
    } catch (Unreadable fault) {
      outcome.show(Health.WARNING, "The rate '" + rate.getText() + "' " + fault.getMessage());
      rate.setFocus();
    }
  }

  private void message(Consumer<MessageCommand> say) {
    Optional<Map<String, Object>> values = form.values();
    if (values.isEmpty()) {
      form.showProblem();
    } else {
      command(values.get()).ifPresent(say);
    }
  }

  /** What is repeated follows the form, as long as all of it can be read. */
  private void changed() {
    if (repeating) {
      form.values().flatMap(this::command).ifPresent(model.speaker()::change);
    }
  }

  private Optional<MessageCommand> command(Map<String, Object> values) {
    return about.flatMap(a -> shape().map(shape -> new MessageCommand(a.key().name(), shape.type(), values)));
  }

  private Optional<RecordShape> shape() {
    return about.flatMap(Described::description).flatMap(d -> d.shape());
  }

  /** The newest message is heard where it is not echoed already; the topic is given up after that. */
  private void prefill() {
    Optional<Key> key = about.map(Described::key);
    awaited = true;
    prefill.setEnabled(false);
    model.echo(key);
  }

  private void fillAwaited(TopicsViewState look) {
    if (!awaited) {
      prefill.setEnabled(look.echo().obstacle().isEmpty());
      return;
    }
    Optional<DynamicRecord> record =
        look.echo().record().filter(r -> look.wishes().echoed().equals(about.map(Described::key)));
    if (record.isPresent()) {
      awaited = false;
      form.fill(record.get());
      model.echo(Optional.empty());
    } else {
      outcome.show(Health.WAITING, "Waiting for a message of the topic");
    }
  }

  private double hertz() throws Unreadable {
    return TypedText.within(rate.getText(), Speaker.SLOWEST, Speaker.FASTEST, RATES);
  }

  private Text rate(Composite parent, Theme theme) {
    Text text = new Text(parent, SWT.SINGLE | SWT.RIGHT);
    text.setText("10");
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    text.setToolTipText("Messages per second, " + RATES);
    GridData data = Boxes.middle();
    data.widthHint = RATE_WIDTH;
    text.setLayoutData(data);
    text.addListener(SWT.DefaultSelection, e -> repeat());
    return text;
  }

  private static void label(Composite parent, Theme theme, String words) {
    new PlainLabel(parent, SWT.NONE, theme, Face.BODY, Role.DIM).setText(words);
  }
}
