package org.robotui.core.internal.config.model;

import java.util.List;
import java.util.Optional;
import org.robotui.api.RficType;
import org.robotui.api.RuicType;
import org.robotui.api.UicType;

/** The component types that are installed now. */
public interface TypeLookup {
  /**
   * A type of robot interface.
   *
   * @param id its id
   * @return the type, or none where it is not installed now
   */
  Optional<RficType> rfic(String id);

  /**
   * A type of view.
   *
   * @param id its id
   * @return the type, or none where it is not installed now
   */
  Optional<UicType> uic(String id);

  /**
   * A type of RUIC.
   *
   * @param id its id
   * @return the type, or none where it is not installed now
   */
  Optional<RuicType> ruic(String id);

  /**
   * All types of robot interfaces, for suggestions.
   *
   * @return ids, sorted
   */
  List<String> rficIds();

  /**
   * All types of views, for suggestions.
   *
   * @return ids, sorted
   */
  List<String> uicIds();

  /**
   * All types of RUICs, for suggestions.
   *
   * @return ids, sorted
   */
  List<String> ruicIds();
}
