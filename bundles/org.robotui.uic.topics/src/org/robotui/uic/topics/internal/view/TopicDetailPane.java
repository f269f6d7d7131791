package org.robotui.uic.topics.internal.view;

import java.util.EnumMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Display;
import org.robotui.api.port.Browser.Kind;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.MessagePane;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.show.SubjectMenu;
import org.robotui.uic.topics.internal.model.Described;
import org.robotui.uic.topics.internal.model.Key;
import org.robotui.uic.topics.internal.model.TopicsModel;
import org.robotui.uic.topics.internal.model.TopicsViewState;

/**
 * All about the selected thing, on its leaves. What is echoed follows the selection once it rests. Display thread.
 */
final class TopicDetailPane {
  /** The leaves. */
  enum Leaf {
    ABOUT("About"), ECHO("Echo"), MESSAGES("Messages"), PUBLISH("Publish");

    private final String label;

    Leaf(String label) {
      this.label = label;
    }
  }

  private static final int REST_MILLIS = 300;

  private final TopicsModel model;
  private final Display display;
  private final Composite root;
  private final Composite bar;
  private final Composite rule;
  private final Heading heading;
  private final Composite stack;
  private final StackLayout leaves = new StackLayout();
  private final Map<Leaf, QuietButton> tabs = new EnumMap<>(Leaf.class);
  private final MessagePane nothing;
  private final AboutPane about;
  private final EchoPane echo;
  private final MessagesPane messages;
  private final PublishPane publish;
  private final Runnable rested = this::listen;
  private Optional<Key> selected = Optional.empty();
  private Leaf leaf = Leaf.ABOUT;

  TopicDetailPane(Composite parent, Theme theme, TopicsModel model, Consumer<Key> follow, String ruic,
      SubjectMenu subjects) {
    this.model = model;
    this.display = parent.getDisplay();
    root = Boxes.panel(parent, theme, 1);
    bar = Boxes.bar(root, theme, 1 + Leaf.values().length);
    heading = new Heading(bar, theme);
    GridData wide = new GridData(SWT.FILL, SWT.CENTER, true, false);
    wide.heightHint = Heading.HEIGHT;
    wide.widthHint = 0;
    heading.control().setLayoutData(wide);
    for (Leaf each : Leaf.values()) {
      tabs.put(each, new QuietButton(bar, theme, () -> open(each)).text(each.label));
      tabs.get(each).setLayoutData(Boxes.middle());
    }
    rule = Boxes.rule(root, theme);
    stack = new Composite(root, SWT.NONE);
    stack.setBackground(theme.color(Role.PANEL));
    stack.setLayoutData(Boxes.fill());
    stack.setLayout(leaves);
    nothing = new MessagePane(stack, theme);
    nothing.show(Health.NONE, "Nothing is selected",
        "Select a line to see who uses it, what it carries and what it is made of.");
    about = new AboutPane(stack, theme, follow);
    echo = new EchoPane(stack, theme, model, ruic, subjects);
    messages = new MessagesPane(stack, theme);
    publish = new PublishPane(stack, theme, model);
    leaves.topControl = nothing.control();
    root.addListener(SWT.Dispose, e -> display.timerExec(-1, rested));
  }

  Control control() {
    return root;
  }

  AboutPane about() {
    return about;
  }

  MessagesPane messages() {
    return messages;
  }

  PublishPane publish() {
    return publish;
  }

  /** Turns to a thing; its messages are asked for after a moment, so that passing by asks for nothing. */
  void select(Optional<Key> key) {
    if (!key.equals(selected)) {
      selected = key;
      model.echo(Optional.empty());
      model.listMessages(Optional.empty());
      display.timerExec(REST_MILLIS, rested);
    }
  }

  /** Opens the messages of the selected topic now. */
  void open() {
    if (selected.filter(key -> key.kind() == Kind.TOPIC).isPresent()) {
      open(Leaf.ECHO);
    }
  }

  void open(Leaf wanted) {
    leaf = wanted;
    display.timerExec(-1, rested);
    listen();
    show(model.look());
  }

  void show(TopicsViewState look) {
    Optional<Described> described = look.described().filter(d -> selected.equals(Optional.of(d.key())));
    Leaf seen = seen();
    tabs.forEach((each, tab) -> {
      boolean possible = isTopic();
      tab.checked(possible && each == seen);
      tab.setVisible(possible);
    });
    if (Boxes.seen(bar, selected.isPresent()) | Boxes.seen(rule, selected.isPresent())) {
      root.layout();
    }
    heading.show(selected.map(Key::name).orElse(""), described.map(Described::type).orElse(""));
    turn(described.isEmpty() ? nothing.control() : control(seen));
    described.ifPresent(d -> show(look, seen, d));
  }

  private void show(TopicsViewState look, Leaf seen, Described described) {
    switch (seen) {
      case ABOUT -> about.show(described);
      case ECHO -> echo.show(look);
      case MESSAGES -> messages.show(look.messages());
      case PUBLISH -> publish.show(look, described);
    }
  }

  private Control control(Leaf seen) {
    return switch (seen) {
      case ABOUT -> about.control();
      case ECHO -> echo.control();
      case MESSAGES -> messages.control();
      case PUBLISH -> publish.control();
    };
  }

  private void turn(Control next) {
    if (leaves.topControl != next) {
      if (leaves.topControl == publish.control()) {
        model.speaker().stop("its form was left");
      }
      leaves.topControl = next;
      stack.layout();
    }
  }

  /** Only topics have more than one leaf. */
  private Leaf seen() {
    return isTopic() ? leaf : Leaf.ABOUT;
  }

  private boolean isTopic() {
    return selected.filter(key -> key.kind() == Kind.TOPIC).isPresent();
  }

  private void listen() {
    model.echo(seen() == Leaf.ECHO ? selected : Optional.empty());
    model.listMessages(seen() == Leaf.MESSAGES ? selected : Optional.empty());
  }
}
