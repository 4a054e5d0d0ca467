// The only file that knows Embree (3 or 4): user geometry whose boxes it sorts and whose hits are
// ours.
#if __has_include(<embree4/rtcore.h>)
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

#include <algorithm>
#include <cmath>
#include <limits>

#include "math/error.hpp"
#include "render/bounded_objects.hpp"

namespace icespar {
namespace {

#if RTC_VERSION_MAJOR >= 4
using QueryContext = RTCRayQueryContext;
#else
using QueryContext = RTCIntersectContext;
#endif

/// What a query carries through Embree: the ray in double, and the answer.
struct Query : QueryContext {
    const BoundedObjects* objects = nullptr;
    Ray ray{};
    Departure from{};
    Hit* hit = nullptr;
    double start = 0;  ///< where the float ray begins on the ray in double
    bool found = false;
};

float rounded_down(double v) {
    return std::nextafter(static_cast<float>(v), -std::numeric_limits<float>::infinity());
}
float rounded_up(double v) {
    return std::nextafter(static_cast<float>(v), std::numeric_limits<float>::infinity());
}

void bounds_of(const RTCBoundsFunctionArguments* args) {
    const auto& b = static_cast<const BoundedObjects*>(args->geometryUserPtr)->bounds(args->primID);
    RTCBounds& out = *args->bounds_o;
    out.lower_x = rounded_down(b.low.x);
    out.lower_y = rounded_down(b.low.y);
    out.lower_z = rounded_down(b.low.z);
    out.upper_x = rounded_up(b.high.x);
    out.upper_y = rounded_up(b.high.y);
    out.upper_z = rounded_up(b.high.z);
}

void intersect(const RTCIntersectFunctionNArguments* args) {
    if (args->valid[0] == 0) return;
    auto& query = *static_cast<Query*>(args->context);
    if (!query.objects->meet(args->primID, query.ray, query.from, *query.hit)) return;
    query.found = true;
    auto& ray = reinterpret_cast<RTCRayHit*>(args->rayhit)->ray;
    ray.tfar = std::min(ray.tfar, rounded_up(query.hit->distance - query.start));
}

}  // namespace

struct BoundedObjects::Embree {
    RTCDevice device = rtcNewDevice("threads=1");
    RTCScene scene = nullptr;
    ~Embree() {
        if (scene != nullptr) rtcReleaseScene(scene);
        if (device != nullptr) rtcReleaseDevice(device);
    }
};

BoundedObjects::BoundedObjects(const World& world, const std::vector<Bounds>& bounds)
    : world_(world), bounds_(bounds), embree_(std::make_unique<Embree>()) {
    Vec3 low = bounds.front().low, high = bounds.front().high;
    for (const Bounds& b : bounds) {
        low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
        high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
    }
    centre_ = 0.5 * (low + high);
    radius_ = 0.5 * length(high - low);
    if (embree_->device == nullptr) throw Error("Embree could not start: check its installation");
    embree_->scene = rtcNewScene(embree_->device);
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, static_cast<unsigned>(bounds_.size()));
    rtcSetGeometryUserData(geometry, this);
    rtcSetGeometryBoundsFunction(geometry, bounds_of, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersect);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(embree_->scene);
    if (rtcGetDeviceError(embree_->device) != RTC_ERROR_NONE) {
        throw Error("Embree could not arrange the scene's objects: are their sizes within 1e18?");
    }
}

BoundedObjects::~BoundedObjects() = default;

bool BoundedObjects::nearest(const Ray& ray, const Departure& from, Hit& hit) const {
    Query query;
#if RTC_VERSION_MAJOR >= 4
    rtcInitRayQueryContext(&query);
#else
    rtcInitIntersectContext(&query);
#endif
    query.objects = this;
    query.ray = ray;
    query.from = from;
    query.hit = &hit;
    // The float ray begins close to the objects, however far away the ray itself does.
    query.start = std::max(0.0, dot(centre_ - ray.origin, ray.direction) - 2 * radius_);
    if (!(query.start < hit.distance)) return false;
    const Vec3 origin = ray.origin + query.start * ray.direction;
    RTCRayHit rayhit{};
    rayhit.ray.org_x = static_cast<float>(origin.x);
    rayhit.ray.org_y = static_cast<float>(origin.y);
    rayhit.ray.org_z = static_cast<float>(origin.z);
    rayhit.ray.dir_x = static_cast<float>(ray.direction.x);
    rayhit.ray.dir_y = static_cast<float>(ray.direction.y);
    rayhit.ray.dir_z = static_cast<float>(ray.direction.z);
    rayhit.ray.tfar = std::isfinite(hit.distance) ? rounded_up(hit.distance - query.start)
                                                  : std::numeric_limits<float>::infinity();
    rayhit.ray.mask = ~0u;
    rayhit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments args;
    rtcInitIntersectArguments(&args);
    args.context = &query;
    rtcIntersect1(embree_->scene, &rayhit, &args);
#else
    rtcIntersect1(embree_->scene, &query, &rayhit);
#endif
    return query.found;
}

}  // namespace icespar
