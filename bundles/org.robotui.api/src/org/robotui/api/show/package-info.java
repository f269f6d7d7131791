/**
 * What a user points at in one view and wants to see in another, and how views say what they can show. Views meet here
 * without knowing each other.
 */
@org.osgi.annotation.versioning.Version("1.0.0")
package org.robotui.api.show;
