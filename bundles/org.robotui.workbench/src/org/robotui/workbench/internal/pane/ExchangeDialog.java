package org.robotui.workbench.internal.pane;

import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Shell;
import org.robotui.api.host.ExchangeOutcome;
import org.robotui.api.host.ExchangePreview;
import org.robotui.api.host.ExchangePreview.Verdict;
import org.robotui.api.host.Host;
import org.robotui.api.host.InterfaceConfig;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Icon;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.workbench.internal.model.ExchangeModel;
import org.robotui.workbench.internal.model.ExchangeRow;

/**
 * Another framework for a robot interface that runs: a form, what would become of every connection, and the exchange.
 * The robot goes on until the last button is pressed. Display thread only.
 */
public final class ExchangeDialog {
  private static final int REFRESH_MILLIS = 250;
  private static final int WIDTH = 1180;
  private static final int HEIGHT = 640;
  private static final int FORM = 400;

  private final Theme theme;
  private final ExchangeModel model;
  private final Consumer<String> done;
  private final Shell shell;
  private final InterfaceForm form;
  private final MatchingTable matching;
  private final NoticeLine verdict;
  private final NoticeLine notes;
  private final QuietButton tryIt;
  private final QuietButton exchange;
  private final QuietButton written;
  private boolean applying;
  private boolean refreshing;

  /**
   * Makes the window.
   *
   * @param parent over which it opens
   * @param theme colours and fonts
   * @param host knows the frameworks
   * @param model what is wanted
   * @param done is told what was done, after it
   */
  public ExchangeDialog(Shell parent, Theme theme, Host host, ExchangeModel model, Consumer<String> done) {
    this.theme = theme;
    this.model = model;
    this.done = done;
    shell = DialogShell.over(parent, theme, "Change the framework of " + model.ruic().name());
    shell.setLayout(DialogShell.layout(2, 0, 0));
    form = new InterfaceForm(shell, theme, host, model, this::edited);
    GridData left = new GridData(SWT.FILL, SWT.FILL, false, true);
    left.widthHint = FORM;
    form.setLayoutData(left);
    matching = new MatchingTable(shell, theme, model::choose);
    matching.control().setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true));
    notes = line();
    verdict = line();
    Composite buttons = new Composite(shell, SWT.NONE);
    buttons.setBackground(theme.color(Role.TITLE));
    buttons.setLayout(DialogShell.layout(5, Theme.EDGE, 0));
    buttons.setLayoutData(new GridData(SWT.FILL, SWT.BOTTOM, true, false, 2, 1));
    written = DialogShell.button(buttons, theme, this::asWritten).icon(Icon.UNDO).text("As the file says")
        .hint("Go back to what the configuration says");
    new Gap(buttons).setLayoutData(new GridData(SWT.FILL, SWT.CENTER, true, false));
    DialogShell.button(buttons, theme, shell::close).text("Cancel").hint("Change nothing (Esc)");
    tryIt = DialogShell.button(buttons, theme, this::tryIt).icon(Icon.PLAY).text("Try")
        .hint("Connect beside the running interface, and show what would become of the connections");
    exchange =
        DialogShell.button(buttons, theme, this::exchange).text("Exchange")
            .hint("Stop what is driven, release control, and exchange");
    shell.addListener(SWT.Dispose, e -> model.close());
    DialogShell.place(shell, WIDTH, HEIGHT);
    show();
  }

  /** Shows it until it is closed. */
  public void open() {
    shell.open();
    form.setFocus();
    begin();
  }

  /** Shows something that is wanted already, and tries it: what somebody wrote into the file. */
  public void open(InterfaceConfig wanted) {
    want(wanted);
    shell.open();
    tryIt();
    begin();
  }

  private void begin() {
    if (!refreshing) {
      refreshing = true;
      refresh();
    }
  }

  /** Wants something else, in the window that stands. */
  public void want(InterfaceConfig wanted) {
    model.want(wanted);
    form.show();
    show();
  }

  /** Whether it was closed. */
  public boolean isClosed() {
    return shell.isDisposed();
  }

  /** The window, for tests. */
  public Shell shell() {
    return shell;
  }

  private void edited() {
    show();
  }

  /** Connects beside the running interface. */
  void tryIt() {
    if (form.isFine()) {
      model.tryIt();
      matching.message(Health.WAITING, "Connecting", "The running interface goes on.");
      show();
    }
  }

  private void asWritten() {
    model.written().ifPresent(w -> {
      want(w);
      tryIt();
    });
  }

  /** Exchanges what was tried. */
  void exchange() {
    boolean goWithout = model.preview().filter(p -> p.verdict() != Verdict.READY).isPresent();
    applying = true;
    show();
    model.apply(goWithout).thenAccept(outcome -> {
      if (!shell.isDisposed()) {
        shell.getDisplay().asyncExec(() -> ended(outcome));
      }
    });
  }

  private void ended(ExchangeOutcome outcome) {
    applying = false;
    if (shell.isDisposed()) {
      return;
    }
    switch (outcome) {
      case ExchangeOutcome.Done d -> {
        String words = model.ruic().name() + ": " + model.wanted().id() + " is " + label() + " now";
        model.ended();
        shell.close();
        done.accept(words);
      }
      case ExchangeOutcome.Refused r -> show();
      case ExchangeOutcome.WentBack w -> {
        model.ended();
        show();
        matching.message(Health.BAD, "It went back", w.reason());
      }
    }
  }

  private String label() {
    return model.type().map(t -> t.descriptor().label()).orElse(model.wanted().type());
  }

  private void refresh() {
    if (!shell.isDisposed()) {
      show();
      shell.getDisplay().timerExec(REFRESH_MILLIS, this::refresh);
    }
  }

  private void show() {
    Optional<ExchangePreview> preview = applying ? Optional.empty() : model.preview();
    preview.filter(p -> !p.lines().isEmpty()).ifPresent(p -> matching.show(ExchangeRow.of(p)));
    if (preview.isEmpty() && !applying && model.tried().isEmpty() && form.isFine()) {
      verdict.show(Health.NONE,
          model.isUnchanged() ? "This is what runs now." : "Press Try to see what would become of the connections.");
    }
    preview.ifPresent(this::judge);
    if (applying) {
      verdict.show(Health.WAITING, "Exchanging: the robot is stopped first");
    }
    String said = preview.map(p -> String.join("; ", p.notes())).orElse("");
    notes.show(said.isEmpty() ? Health.NONE : Health.WARNING, said);
    buttons(preview);
  }

  private void judge(ExchangePreview p) {
    Health health = switch (p.verdict()) {
      case READY -> Health.OK;
      case PENDING -> Health.WAITING;
      case INCOMPLETE, FAILED -> Health.BAD;
    };
    String words = switch (p.verdict()) {
      case READY -> "It can be exchanged: " + p.sentence() + ".";
      case PENDING -> p.sentence();
      case INCOMPLETE -> "It would not cover what is used: " + p.sentence();
      case FAILED -> "It cannot be started: " + p.sentence();
    };
    verdict.show(health, words);
  }

  private void buttons(Optional<ExchangePreview> preview) {
    Verdict now = preview.map(ExchangePreview::verdict).orElse(Verdict.FAILED);
    written.setVisible(model.written().isPresent());
    tryIt.setEnabled(!applying && form.isFine() && preview.isEmpty());
    exchange.setEnabled(!applying && preview.isPresent() && now != Verdict.FAILED);
    exchange.text(switch (now) {
      case READY, FAILED -> "Exchange";
      case PENDING -> "Exchange without a trial";
      case INCOMPLETE -> "Go without " + preview.map(p -> p.missing().size()).orElse(0);
    });
    exchange.checked(now == Verdict.READY);
    exchange.requestLayout();
  }

  private NoticeLine line() {
    NoticeLine line = new NoticeLine(shell, theme, Face.BODY);
    ((GridData) line.control().getLayoutData()).horizontalSpan = 2;
    return line;
  }
}
