package org.robotui.workbench.internal.rcp;

import java.util.Optional;
import org.eclipse.core.commands.AbstractHandler;
import org.eclipse.core.commands.ExecutionEvent;
import org.eclipse.core.commands.ExecutionException;
import org.eclipse.ui.PlatformUI;
import org.robotui.api.replay.Bookmark;
import org.robotui.api.replay.Timeline;
import org.robotui.workbench.internal.WorkbenchServices;
import org.robotui.workbench.internal.timeline.LiveTimeline;
import org.robotui.workbench.internal.timeline.TimelineMoves;

/** The commands of recordings, so that keys and the search find them. Without recordings they do nothing. */
public final class TimelineCommands extends AbstractHandler {
  private static final String PREFIX = "org.robotui.workbench.command.timeline.";
  private static final double FAR = 10;

  @Override
  public Object execute(ExecutionEvent event) throws ExecutionException {
    LiveTimeline live = WorkbenchServices.session().timeline();
    Optional<Timeline> timeline = live.timeline();
    if (timeline.isPresent()) {
      run(event.getCommand().getId().substring(PREFIX.length()), live, timeline.get());
    }
    return null; // as the platform asks of every handler
  }

  private static void run(String command, LiveTimeline live, Timeline timeline) throws ExecutionException {
    TimelineMoves moves = new TimelineMoves(timeline);
    switch (command) {
      case "play" -> moves.toggle();
      case "step" -> live.step(true);
      case "step.back" -> live.step(false);
      case "jump" -> moves.jump(1);
      case "jump.back" -> moves.jump(-1);
      case "jump.far" -> moves.jump(FAR);
      case "jump.far.back" -> moves.jump(-FAR);
      case "start" -> moves.end(false);
      case "end" -> moves.end(true);
      case "bookmark" -> timeline.mark(new Bookmark(timeline.state().position(), ""));
      case "bookmark.next" -> moves.bookmark(true);
      case "bookmark.former" -> moves.bookmark(false);
      case "find" -> WorkbenchServices.session().search().ask();
      case "pictures" -> WindowActions.layoutOf(PlatformUI.getWorkbench().getActiveWorkbenchWindow())
          .ifPresent(LayoutActions::savePictures);
      case "faster" -> moves.faster(true);
      case "slower" -> moves.faster(false);
      default -> throw new ExecutionException("no such command: " + PREFIX + command);
    }
  }
}
