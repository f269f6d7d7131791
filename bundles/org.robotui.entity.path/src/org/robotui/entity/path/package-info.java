/**
 * A planned way and its goal.
 */
@org.osgi.annotation.versioning.Version("2.0.0")
package org.robotui.entity.path;
