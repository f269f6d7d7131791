package org.robotui.ui.ask;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.custom.SashForm;
import org.eclipse.swt.custom.StackLayout;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.robotui.api.port.Browser.Description;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ask.AskModel.Shown;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.MessagePane;
import org.robotui.ui.control.QuietButton;
import org.robotui.ui.control.RecordForm;
import org.robotui.ui.control.RecordTree;

/** What is chosen: a form to fill in, a button to ask, and what came back. Display thread. */
final class AskDetail {
  private static final int HEAD = 32;
  private static final int PART = 24;
  private static final int FOOT = 40;
  private static final int ROOM_BESIDE = 420;
  private static final int[] SHARES = {52, 48};
  private static final int[] HISTORY_SHARES = {74, 26};

  private final AskWords words;
  private final AskModel model;
  private final Runnable changed;
  private final Caption title;
  private final Caption outcome;
  private final Caption replyTitle;
  private final RecordForm form;
  private final RecordTree tree;
  private final QuietButton button;
  private final Optional<QuietButton> cancel;
  private final AskHistory history;
  private final StackLayout leaves = new StackLayout();
  private final Composite stack;
  private final Composite work;
  private Optional<Detail> detail = Optional.empty();
  private Optional<Asked> current = Optional.empty();

  AskDetail(Composite parent, Theme theme, AskWords words, AskModel model, Runnable changed) {
    this.words = words;
    this.model = model;
    this.changed = changed;
    stack = Boxes.panel(parent, theme, 1);
    stack.setLayout(leaves);
    MessagePane nothing = new MessagePane(stack, theme);
    nothing.show(Health.NONE, "Nothing chosen", "Choose one of the " + words.things() + " at the left.");
    leaves.topControl = nothing.control();
    Composite box = Boxes.panel(stack, theme, 1);
    work = box;
    title = new Caption(inset(box, theme), theme, Face.BODY_STRONG);
    title.control().setLayoutData(Boxes.line(HEAD));
    SashForm rows = Boxes.split(box, theme, SWT.VERTICAL);
    rows.setLayoutData(Boxes.fill());
    SashForm parts = Boxes.split(rows, theme, SWT.HORIZONTAL);
    Composite left = Boxes.panel(parts, theme, 1);
    part(left, theme).say(Optional.empty(), words.request(), "");
    form = new RecordForm(left, theme).onSubmit(this::ask).onChange(this::enable);
    form.control().setLayoutData(Boxes.fill());
    Composite foot = Boxes.inset(left, theme, words.cancels() ? 3 : 2, Theme.EDGE, Theme.STEP);
    foot.setLayoutData(Boxes.line(FOOT));
    button = new QuietButton(foot, theme, this::ask).text(words.verb()).fill(Role.ACCENT)
        .hint(words.verb() + " (Ctrl+Enter)");
    button.setLayoutData(new GridData(SWT.BEGINNING, SWT.CENTER, false, false));
    cancel =
        words.cancels() ? Optional.of(new QuietButton(foot, theme, this::cancel).text("Cancel")) : Optional.empty();
    outcome = new Caption(foot, theme, Face.BODY);
    outcome.control().setLayoutData(Boxes.line(PART));
    Composite right = Boxes.panel(parts, theme, 1);
    replyTitle = part(right, theme);
    tree = new RecordTree(right, theme);
    tree.control().setLayoutData(Boxes.fill());
    parts.setWeights(SHARES);
    parts.addListener(SWT.Resize,
        e -> parts.setOrientation(parts.getSize().x < ROOM_BESIDE ? SWT.VERTICAL : SWT.HORIZONTAL));
    history = new AskHistory(rows, theme, this::look);
    rows.setWeights(HISTORY_SHARES);
  }

  private static Composite inset(Composite parent, Theme theme) {
    Composite inset = Boxes.inset(parent, theme, 1, Theme.EDGE, 0);
    inset.setLayoutData(new GridData(SWT.FILL, SWT.TOP, true, false));
    return inset;
  }

  private static Caption part(Composite parent, Theme theme) {
    Caption caption = new Caption(inset(parent, theme), theme, Face.SMALL_STRONG);
    caption.control().setLayoutData(Boxes.line(PART));
    return caption;
  }

  private void ask() {
    if (detail.isPresent() && detail.get() instanceof Detail.Known known) {
      form.values().ifPresentOrElse(values -> model.questions().ask(known.entry(), values), form::showProblem);
      history.newest();
      changed.run();
    }
  }

  private void cancel() {
    current.filter(Asked::running).ifPresent(a -> model.questions().cancel(a.number()));
  }

  private void look() {
    changed.run();
  }

  void show(Shown shown) {
    if (!shown.detail().equals(detail)) {
      detail = shown.detail();
      describe();
    }
    if (leaves.topControl != work && !(detail.isEmpty() && shown.asked().isEmpty())) {
      leaves.topControl = work;
      stack.layout();
    }
    history.show(shown.asked());
    current = history.chosen().or(() -> mine(shown.asked()));
    answer();
    enable();
  }

  private Optional<Asked> mine(List<Asked> all) {
    return all.stream().filter(a -> detail.map(Detail::entry).filter(a.entry()::equals).isPresent()).findFirst();
  }

  private void describe() {
    switch (detail.orElseThrow()) {
      case Detail.Asked a -> title.say(Optional.of(Health.WAITING), a.entry().item().name(), "asking the robot");
      case Detail.Unknown u -> title.say(Optional.of(Health.BAD), u.entry().item().name(), u.reason());
      case Detail.Known k -> {
        title.say(Optional.empty(), k.entry().item().name(), facts(k.description()));
        k.description().shape().ifPresent(form::shape);
      }
    }
  }

  private static String facts(Description description) {
    Map<String, String> facts = description.facts();
    return String.join("   ", facts.entrySet().stream()
        .map(e -> e.getKey().equals("type") ? e.getValue() : e.getKey() + " " + e.getValue()).toList());
  }

  private boolean askable() {
    return detail.filter(Detail.Known.class::isInstance).map(Detail.Known.class::cast)
        .filter(k -> k.description().shape().isPresent()).isPresent();
  }

  private void enable() {
    button.setEnabled(askable());
    form.control().setVisible(askable());
    cancel.ifPresent(c -> c.setEnabled(current.filter(Asked::running).isPresent()));
  }

  private void answer() {
    if (current.isEmpty()) {
      outcome.say(Optional.empty(), "", "");
      replyTitle.say(Optional.empty(), words.reply(), "");
      tree.clear();
      tree.message(Health.NONE, detail.isEmpty() ? "Nothing chosen" : "Not asked yet",
          detail.isEmpty() ? "Choose one of the " + words.things() + " at the left."
              : "Fill in the form and press " + words.verb() + ".");
      return;
    }
    Asked asked = current.get();
    outcome.say(Optional.of(asked.health()), asked.words(), AskHistory.took(asked));
    boolean waits = asked.result().isEmpty() && asked.feedback().isPresent();
    replyTitle.say(Optional.empty(), waits ? "Feedback" : words.reply(), asked.entry().item().name());
    asked.result().or(asked::feedback).ifPresentOrElse(record -> {
      tree.noMessage();
      tree.show(record);
    }, () -> {
      tree.clear();
      tree.message(asked.health(), asked.running() ? "Waiting" : "Nothing came back", asked.words());
    });
  }
}
