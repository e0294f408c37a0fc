//! C: a struct that has the layout of the frame, filled and read field by field. See `images.c`.

use super::c::{c, whole};
use super::images::{images, values};
use super::{Image, Pack, Unpack, Values};

images!(c whole "place_" "fetch_");
