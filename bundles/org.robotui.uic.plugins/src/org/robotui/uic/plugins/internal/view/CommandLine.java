package org.robotui.uic.plugins.internal.view;

import java.util.Optional;
import java.util.function.BiConsumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Text;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.QuietButton;

/** A field for words that a plugin understands; Enter sends them. Display thread. */
final class CommandLine {
  private final Composite root;
  private final Text text;
  private final QuietButton send;
  private final BiConsumer<String, String> commanded;
  private Optional<String> plugin = Optional.empty();

  CommandLine(Composite parent, Theme theme, BiConsumer<String, String> commanded) {
    this.commanded = commanded;
    root = Boxes.bar(parent, theme, 2);
    text = new Text(root, SWT.SINGLE);
    text.setFont(theme.font(Face.FIGURES));
    text.setBackground(theme.color(Role.GROUND));
    text.setForeground(theme.color(Role.TEXT));
    GridData wide = new GridData(SWT.FILL, SWT.CENTER, true, false);
    wide.horizontalIndent = Theme.STEP;
    text.setLayoutData(wide);
    text.addListener(SWT.DefaultSelection, e -> commit());
    text.addListener(SWT.Modify, e -> enable());
    send = new QuietButton(root, theme, this::commit).text("Send");
    send.setLayoutData(Boxes.middle());
    enable();
  }

  Text text() {
    return text;
  }

  void focus() {
    text.setFocus();
  }

  /** For which plugin, if for any; whether the line came or went. */
  boolean show(Optional<String> name, boolean usable) {
    if (!plugin.equals(name)) {
      plugin = name;
      text.setText("");
      text.setMessage(name.map(n -> "Command for " + n).orElse(""));
    }
    if (text.getEnabled() != usable) {
      text.setEnabled(usable);
      enable();
    }
    return Boxes.seen(root, name.isPresent());
  }

  private void enable() {
    send.setEnabled(text.getEnabled() && !text.getText().isBlank());
  }

  private void commit() {
    String words = text.getText().strip();
    if (!words.isEmpty()) {
      plugin.ifPresent(name -> commanded.accept(name, words));
      text.setText("");
    }
  }
}
