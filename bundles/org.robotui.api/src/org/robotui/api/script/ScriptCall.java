package org.robotui.api.script;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.robotui.api.command.Principal;
import org.robotui.api.host.Host;
import org.robotui.api.host.PortAccess;
import org.robotui.api.host.Ruic;

/** One call of a function by a script: its arguments, and what the script may use. On the thread of the script only. */
public interface ScriptCall {
  /**
   * An argument.
   *
   * @param index of the parameter, from 0
   * @return a plain value or a {@link ScriptCallback}; none where it was left out, or is null or undefined
   */
  Optional<Object> argument(int index);

  /**
   * A text.
   *
   * @param index of the parameter
   * @return the text
   * @throws ScriptFailure where the argument is no text; it names function and parameter
   */
  String text(int index) throws ScriptFailure;

  /**
   * A text that may be left out.
   *
   * @param index of the parameter
   * @return the text, or none
   * @throws ScriptFailure where the argument is something else
   */
  Optional<String> textIf(int index) throws ScriptFailure;

  /**
   * A finite number.
   *
   * @param index of the parameter
   * @return the number
   * @throws ScriptFailure where the argument is no number, or none that is finite
   */
  double number(int index) throws ScriptFailure;

  /**
   * A number that may be left out.
   *
   * @param index of the parameter
   * @param otherwise what it is then
   * @return the number
   * @throws ScriptFailure where the argument is something else
   */
  double number(int index, double otherwise) throws ScriptFailure;

  /**
   * A span of time.
   *
   * @param index of the parameter
   * @param otherwise seconds, where it is left out
   * @return not negative, at most a day
   * @throws ScriptFailure where the argument is no such number of seconds
   */
  Duration seconds(int index, double otherwise) throws ScriptFailure;

  /**
   * An object of the script.
   *
   * @param index of the parameter
   * @return plain values by name; empty where it was left out
   * @throws ScriptFailure where the argument is something else
   */
  Map<String, Object> fields(int index) throws ScriptFailure;

  /**
   * A function of the script.
   *
   * @param index of the parameter
   * @return the function
   * @throws ScriptFailure where the argument is something else
   */
  ScriptCallback function(int index) throws ScriptFailure;

  /**
   * The core.
   *
   * @return the host
   */
  Host host();

  /**
   * As whom the script gives commands.
   *
   * @return the principal, the same for all calls of a session
   */
  Principal principal();

  /**
   * The RUIC that the script uses.
   *
   * @param name of another one, where the script names it
   * @return the named one; else that which was chosen with {@link #use}, else the first
   * @throws ScriptFailure where there is no such RUIC
   */
  Ruic ruic(Optional<String> name) throws ScriptFailure;

  /**
   * Chooses the RUIC that the script uses from now on.
   *
   * @param ruic which
   */
  void use(Ruic ruic);

  /**
   * The ports of a RUIC as this script may use them.
   *
   * @param ruic which
   * @return the same for all calls of a session, which closes it
   */
  PortAccess access(Ruic ruic);

  /**
   * Says something where the script was started.
   *
   * @param text may have several lines
   */
  void print(String text);

  /**
   * Waits. A script that waits is not taken for one that loops.
   *
   * @param time how long
   * @throws InterruptedException where the script is stopped
   */
  void pause(Duration time) throws InterruptedException;
}
