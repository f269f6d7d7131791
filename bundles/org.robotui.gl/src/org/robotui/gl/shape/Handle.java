package org.robotui.gl.shape;

import java.util.List;
import org.robotui.geometry.Vector3;

/**
 * How a part is moved by hand. All methods are called on the worker thread of the scene, one at a time; they must not
 * block.
 */
public interface Handle {
  /**
   * The pointer grips it.
   *
   * @param ray under the pointer
   * @param place where the part was hit, in the fixed frame
   */
  void press(Ray ray, Vector3 place);

  /**
   * The pointer moves while it grips.
   *
   * @param ray under the pointer
   */
  void drag(Ray ray);

  /**
   * The pointer lets go, or was taken away.
   *
   * @param clicked true where it did not move in between
   */
  void release(boolean clicked);

  /**
   * What its menu offers.
   *
   * @return the entries, empty without a menu
   */
  default List<Choice> menu() {
    return List.of();
  }

  /**
   * An entry of a menu was chosen.
   *
   * @param id of the choice
   */
  default void choose(int id) {}

  /**
   * An entry of a menu.
   *
   * @param id given back when it is chosen
   * @param label what is read
   * @param checked a tick before it
   * @param children entries below it; where there are some, it is no choice itself
   */
  record Choice(int id, String label, boolean checked, List<Choice> children) {
    /**
     * Copies the list.
     *
     * @param id given back
     * @param label what is read
     * @param checked a tick
     * @param children entries below it
     */
    public Choice {
      children = List.copyOf(children);
    }
  }
}
