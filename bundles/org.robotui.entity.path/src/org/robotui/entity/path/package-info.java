/**
 * A planned way and its goal.
 */
@org.osgi.annotation.versioning.Version("1.1.0")
package org.robotui.entity.path;
