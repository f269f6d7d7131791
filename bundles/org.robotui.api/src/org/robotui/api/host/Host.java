package org.robotui.api.host;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import org.robotui.api.UicType.Surface;
import org.robotui.api.bridge.BridgeConfig;
import org.robotui.api.command.Principal;
import org.robotui.api.config.Setting;
import org.robotui.api.time.PointedTime;

/**
 * The core, as an application sees it: an OSGi service. Methods return at once unless they say otherwise, and are safe
 * for all threads.
 */
public interface Host {
  /**
   * Says where views can be shown, before the first configuration is loaded. Views for other surfaces are left out.
   *
   * @param surface window or text
   * @param principal as whom views give commands
   */
  void open(Surface surface, Principal principal);

  /**
   * Reads a configuration and adds its RUICs. Reads the file, so not on the display thread. From then on the file is
   * watched, see {@link HostListener#configurationChanged}.
   *
   * @param file the YAML file
   * @return what is wrong with it; RUICs without errors are added all the same
   */
  List<Problem> load(Path file);

  /**
   * Reads a configuration and says what would become of it, without connecting to any robot. Reads the file.
   *
   * @param file the YAML file
   * @param wait how long component types may still appear
   * @return problems and matches
   */
  CheckReport check(Path file, Duration wait);

  /**
   * The types of components that are installed now.
   *
   * @return by kind, then by id
   */
  List<Installed> installed();

  /**
   * Which bundles are used by the RUICs that there are now.
   *
   * @return a matrix
   */
  ReuseReport reuse();

  /**
   * Checks a value that a user wants to give to a setting.
   *
   * @param setting which
   * @param value Boolean, Number, String, List or Map
   * @return what is wrong with it and what was expected, or nothing
   */
  Optional<String> wrong(Setting setting, Object value);

  /**
   * The RUICs in the order in which they were added.
   *
   * @return the RUICs
   */
  List<Ruic> ruics();

  /**
   * The windows that the loaded files ask for.
   *
   * @return in the order of loading and writing; their RUICs may have gone, or not have come
   */
  List<WindowConfig> windows();

  /**
   * The bridges that the loaded files ask for.
   *
   * @return in the order of loading and writing; their RUICs may have gone, or not have come
   */
  default List<BridgeConfig> bridges() {
    return List.of();
  }

  /**
   * Begins to put a RUIC together, with a robot interface that is tried at once.
   *
   * @param wanted the robot interface
   * @return what is put together; must be closed
   */
  Composition compose(InterfaceConfig wanted);

  /**
   * Opens files such as recordings as robots.
   *
   * @return always the same
   */
  FileOpener files();

  /**
   * The time at which the user points, which all views share.
   *
   * @return always the same
   */
  PointedTime pointed();

  /**
   * What the configuration files that run can say, to be shown and changed.
   *
   * @return always the same
   */
  ConfigSettings settings();

  /**
   * Tells when RUICs, their states, matches, views or frames change.
   *
   * @param listener is called on a thread of core that all such listeners share; must not block
   * @return ends the subscription when closed
   */
  Subscription listen(HostListener listener);

  /**
   * Tells when RUICs, their states, matches, views or frames change, where the listener wants to be told. At most one
   * task of this listener waits to be executed: what happens again before that task runs is told once, in the order in
   * which it happened first, so that a slow thread is never flooded.
   *
   * @param listener is called by the executor only; what it throws is logged, and it is told what comes next
   * @param executor runs tasks later, one after another, and never on the calling thread: for example on the display
   * thread
   * @return ends the subscription when closed
   */
  Subscription listen(HostListener listener, Executor executor);

  /**
   * The display thread lives. An application with a window calls this from its display thread at least every 50 ms once
   * it has called it for the first time; a silence of 200 ms ends streaming commands of its principal with zero.
   */
  void displayAlive();

  /**
   * Whether the user's attention is with a window. Lost focus ends streaming commands with zero.
   *
   * @param focused true while one of our windows has the focus
   */
  void displayFocused(boolean focused);

  /**
   * Writes what somebody needs to know who helps into one zip that only this user can read: logs, configurations, what
   * users changed, versions, memory, threads and bundles of this process and of others of this user, with what is
   * secret masked. Blocks for seconds, so not on the display thread.
   *
   * @param file is replaced where it exists
   * @return what is in it, a line each
   * @throws IOException where it cannot be written
   */
  List<String> support(Path file) throws IOException;

  /**
   * The configurations that run, for what is given away with them. Reads the files, so not on the display thread.
   *
   * @return their texts by their files, with what is secret masked; those that cannot be read are left out
   */
  Map<Path, String> configurationTexts();

  /**
   * Stops all robots, latched.
   *
   * @param by who stops
   */
  void stopAll(Principal by);

  /**
   * How long {@link #close} may take with what runs now: the robot interfaces of a team end at once, but on as many
   * processors as there are.
   *
   * @param limit how long, where a few robot interfaces run
   * @return as long, or longer where many do
   */
  Duration closeLimit(Duration limit);

  /**
   * Ends all RUICs and blocks until nothing is left or {@link #closeLimit} is over. What we drive is stopped.
   *
   * @param limit how long, where a few robot interfaces run
   * @return what could not be ended, for the log; empty where all is well
   */
  List<String> close(Duration limit);

  /** Ends a subscription. */
  interface Subscription extends AutoCloseable {
    @Override
    void close();
  }
}
