package org.robotui.uic.tftree.internal;

import java.util.Optional;
import java.util.function.UnaryOperator;
import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.robotui.testkit.FakeFrames;
import org.robotui.testkit.FakeUicContext;
import org.robotui.testkit.GalleryWindow;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.Themes;
import org.robotui.ui.UiContext;
import org.robotui.uic.tftree.internal.model.Ask;
import org.robotui.uic.tftree.internal.model.Trees;

/** Shows the view in all its states side by side, for a person to look at: {@code Gallery dark|light}. */
record Gallery(GalleryWindow window, Theme theme) {
  public static void main(String[] arguments) {
    GalleryWindow.show(display -> Themes.of(display, arguments[0]), theme -> theme.color(Role.LINE),
        (window, theme) -> new Gallery(window, theme).fill());
  }

  private void fill() {
    cell(0, 0, 980, 480, Trees.frames(Trees.base()), ask -> ask.select(Optional.of(Trees.id("camera_link"))));
    cell(986, 0, 614, 480, Trees.frames(Trees.faulty(), Trees.refusal()), ask -> ask);
    cell(0, 486, 620, 514, Trees.frames(Trees.faulty()),
        ask -> ask.drawn(false).select(Optional.of(Trees.id("base_footprint"))));
    cell(626, 486, 480, 250, new FakeFrames(), ask -> ask);
    cell(626, 742, 480, 258, Trees.frames(Trees.many(3000)), ask -> ask);
    cell(1112, 486, 488, 250, Trees.frames(Trees.base()), ask -> ask.toggle(Trees.id("base_link")).search("camera"));
    cell(1112, 742, 488, 258, Trees.frames(Trees.base()), ask -> ask.problems(true));
  }

  private void cell(int x, int y, int width, int height, FakeFrames frames, UnaryOperator<Ask> wanted) {
    FakeUicContext context = new FakeUicContext("tftree", new TfTreeType().descriptor().schema());
    context.frames(frames);
    Composite part = window.cell(x, y, width, height);
    TfTreeUic uic = new TfTreeUic(context);
    part.addListener(SWT.Dispose, e -> uic.close());
    uic.ask(wanted.apply(uic.asked()));
    uic.tick(Trees.NOW);
    uic.createControl(part, UiContext.of(theme, part::setData));
    uic.tick(Trees.NOW + 1);
    uic.refresh();
    part.layout(true, true);
  }
}
