package org.robotui.api;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.robotui.api.alert.AlertSource;
import org.robotui.api.command.Output;
import org.robotui.api.command.Principal;
import org.robotui.api.config.SettingsStore;
import org.robotui.api.frame.Frames;
import org.robotui.api.host.RuicView;
import org.robotui.api.port.BrowseInput;
import org.robotui.api.port.BrowsePort;
import org.robotui.api.port.CallPort;
import org.robotui.api.port.Caller;
import org.robotui.api.port.CommandPort;
import org.robotui.api.port.Input;
import org.robotui.api.port.StreamPort;
import org.robotui.api.time.PointedTime;
import org.robotui.api.time.RobotClock;
import org.robotui.data.Data;

/** What core gives to a view. Ports asked for must be among those of its type. All of it is safe for all threads. */
public interface UicContext {
  /**
   * The id of the instance within its RUIC.
   *
   * @return the id
   */
  String instance();

  /**
   * The RUIC to which the view belongs: its components, links and connections.
   *
   * @return a view of it
   */
  RuicView ruic();

  /**
   * The end of a stream.
   *
   * @param <T> the type of the data
   * @param port a port of the type
   * @return the input, the same for each call
   */
  <T extends Data> Input<T> input(StreamPort<T> port);

  /**
   * The end of a command port.
   *
   * @param <T> the type of the commands
   * @param port a port of the type
   * @return the output, the same for each call
   */
  <T extends Data> Output<T> output(CommandPort<T> port);

  /**
   * The end of a call port.
   *
   * @param <Q> the type of requests
   * @param <R> the type of replies
   * @param port a port of the type
   * @return the caller
   */
  <Q, R> Caller<Q, R> caller(CallPort<Q, R> port);

  /**
   * The end of a browse port.
   *
   * @param port a port of the type
   * @return the input
   */
  BrowseInput browse(BrowsePort port);

  /**
   * As whom this view gives commands.
   *
   * @return the principal
   */
  Principal principal();

  /**
   * The clock of the RUIC.
   *
   * @return the clock
   */
  RobotClock clock();

  /**
   * The time at which the user points, in whatever view of the application.
   *
   * @return always the same, for all views
   */
  PointedTime pointed();

  /**
   * The frames of the RUIC's robots.
   *
   * @return the frames
   */
  Frames frames();

  /**
   * All RUICs of the workbench, that of this view among them.
   *
   * @return the RUICs in the order in which they were added
   */
  List<RuicView> ruics();

  /**
   * Has another RUIC shown in place of that of this view, as when the user chooses it in the window. Returns at once;
   * does nothing where there is no such RUIC.
   *
   * @param ruic its name
   */
  void show(String ruic);

  /**
   * Runs what may block: asking a robot, reading or writing a file. The tasks of one view run in order, on a thread
   * that core owns; they are interrupted, and what waits is forgotten, when the view ends.
   *
   * @return takes tasks from any thread; one that throws is logged
   */
  Executor background();

  /**
   * Tells the user of something that cannot wait until the view is looked at. Shown by the application, whatever it
   * shows.
   *
   * @param message a sentence; the name of the RUIC is put before it
   */
  void alert(String message);

  /**
   * Where this view keeps users informed of what lasts, so that they can list, mute and acknowledge it.
   *
   * @return where to say it, always the same
   */
  AlertSource alerts();

  /**
   * The settings of this view, for changing them.
   *
   * @return the store
   */
  SettingsStore settings();

  /**
   * What the instance before this one retained, where core has ended that one as it was late and has made this one in
   * its place.
   *
   * @param <T> the type of it
   * @param type of what the view retains
   * @return what {@link Uic#retain} gave; empty at a first start, and where it gave something else
   */
  default <T> Optional<T> retained(Class<T> type) {
    return Optional.empty();
  }
}
